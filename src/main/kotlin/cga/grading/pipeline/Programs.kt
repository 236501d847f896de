package cga.grading.pipeline

import cga.grading.capture.StandIn
import cga.grading.capture.WorkerFiles
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempFile
import kotlin.io.path.moveTo

/** What the processes in the sandbox are made of: the worker's jar, which is written to [home], the libraries, and this program itself. */
internal class Programs(home: Path) {
    /** The classes that run a submission, apart from all others of ours. */
    val worker: Path = home.createDirectories().toRealPath().resolve("worker.jar")

    /** LWJGL, JOML and Kotlin's library. */
    private val libraries: List<Path> = WorkerFiles.libraries().map { it.toRealPath() }

    init {
        // Another grader may be reading it: it is replaced as a whole, by the same.
        val fresh = createTempFile(worker.parent, "worker", ".jar")
        WorkerFiles.writeJar(fresh)
        // A temporary file is its owner's alone, and the sandbox has another user.
        fresh.toFile().setReadable(true, false)
        fresh.moveTo(worker, overwrite = true)
    }

    /** What a submission is compiled against; Kotlin's library comes with the compiler. */
    val forSubmissions: List<Path> = libraries.filterNot { it.fileName.toString().startsWith("kotlin-stdlib") } + listOf(worker)

    /** What runs a submission must be able to read, its own files aside. */
    val readable: List<Path> = libraries + listOf(worker)

    /** This program's own class path, `lib/` and all. */
    val own: List<Path> =
        System.getProperty("java.class.path").split(File.pathSeparator).flatMap(::expanded).map { it.toRealPath() }

    /** The class that takes the place of the submission's window, whose source is [original]. */
    fun standIn(original: String?): String = StandIn(original).source()

    private fun expanded(entry: String): List<Path> {
        if (!entry.endsWith("*")) return listOf(Path.of(entry)).filter { it.toFile().exists() }
        return File(entry.dropLast(1)).listFiles { file -> file.name.endsWith(".jar") }.orEmpty().sorted().map { it.toPath() }
    }
}

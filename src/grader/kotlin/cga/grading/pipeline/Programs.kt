package cga.grading.pipeline

import cga.framework.AtomicFile
import cga.framework.Home
import cga.grading.capture.WorkerFiles
import cga.grading.prepared.Kind
import cga.grading.sandbox.ClassArchive
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Temporary
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists

/** What the processes in the sandbox are made of: the worker's jar, which is written to [folder], the libraries, and this program itself. */
internal class Programs(folder: Path) {
    /** Where what is made once is kept. */
    val home: Path = folder.createDirectories().toRealPath()

    /** The classes that run a submission, apart from all others of ours. */
    val worker: Path = home.resolve("worker.jar")

    /** LWJGL, JOML and Kotlin's library. */
    private val libraries: List<Path> = WorkerFiles.libraries().map { it.toRealPath() }

    init {
        // Another grader may be reading it: it is replaced as a whole, and only where it is another one, as an archive was made of it.
        val fresh = Temporary.file("worker").also { WorkerFiles.writeJar(it) }
        val isThere = worker.exists() && Files.mismatch(fresh, worker) == -1L
        if (!isThere) {
            AtomicFile.write(worker) { part ->
                fresh.copyTo(part)
                // A temporary file is its owner's alone, and the sandbox has another user.
                part.toFile().setReadable(true, false)
            }
        }
        fresh.deleteExisting()
    }

    /** What a submission is compiled against; Kotlin's library comes with the compiler. */
    val forSubmissions: List<Path> = libraries.filterNot { it.fileName.toString().startsWith("kotlin-stdlib") } + listOf(worker)

    /** What runs a submission must be able to read, its own files aside. */
    val readable: List<Path> get() = libraries + listOfNotNull(worker, workerArchive.file)

    /** The classes of [worker] and the libraries. */
    val workerArchive: ClassArchive by lazy {
        ClassArchive.of(home, "worker", WorkerFiles.own(worker), WorkerFiles.FLAGS, OURS, listOf(::rehearsal))
    }

    /** This program's own class path, `lib/` and all. */
    val own: List<Path> =
        System.getProperty("java.class.path").split(File.pathSeparator).flatMap(::expanded).map { it.toRealPath() }

    /** This program and no other; null while it is being worked on. */
    val state: String? by lazy { ClassArchive.state(own)?.let { "%08x".format(it.hashCode()) } }

    /** The classes of [own]. */
    val ownArchive: ClassArchive by lazy {
        ClassArchive.of(home, "measure", own, JavaCommand.commonOptions(), OURS, listOf(::rehearsal, ::reading))
    }

    /** Opens a window of the worker's and ends; what it captures goes into [folder]. */
    private fun rehearsal(folder: Path): List<String> =
        listOf("cga.grading.worker.WorkerMain", "cga.grading.worker.Trial", "${folder.resolve("capture")}")

    /** Reads a correct project as if it were handed in. */
    private fun reading(folder: Path): List<String> {
        val home = Home.resolve("").toAbsolutePath()
        return listOf("-Dcga.home=$home", PrepareStep.MAIN, "${home.resolve(Kind.COURSE.reference)}", "$folder", "")
    }

    private companion object {
        /** More than one window needs. */
        val OURS =
            listOf("cga/framework/", "cga/grading/", "cga/reference/", "org/joml/", "kotlin/collections/", "kotlin/jvm/internal/")
    }

    private fun expanded(entry: String): List<Path> {
        if (!entry.endsWith("*")) return listOf(Path.of(entry)).filter { it.toFile().exists() }
        return File(entry.dropLast(1)).listFiles { file -> file.name.endsWith(".jar") }.orEmpty().sorted().map { it.toPath() }
    }
}

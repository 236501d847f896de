package cga.grading.corpus

import cga.grading.capture.CaptureFile
import cga.grading.capture.WorkerFiles
import cga.grading.submission.StandIn
import cga.testing.projectRoot
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.moveTo
import kotlin.io.path.name
import kotlin.io.path.writeText

/**
 * Captures of the corpus' submissions, run without a sandbox since they are our own: what the analysis is developed and judged with.
 * Submissions with the same Kotlin are compiled once. A capture that is there already is kept until the submission changes or
 * [CaptureFile.VERSION].
 */
internal class CorpusCaptures(private val folder: Path = home) : AutoCloseable {
    private val work by lazy { createTempDirectory(folder.createDirectories(), "work") }
    private val worker by lazy { work.resolve("worker.jar").also(WorkerFiles::writeJar) }
    private val idle = ConcurrentLinkedQueue<CaptureHost>()
    private val compiling = ConcurrentHashMap<String, Any>()

    /** Where the capture of [submission] is, once it has been made. */
    fun file(submission: Submission): Path =
        folder.resolve("${submission.name}~%08x.capture".format(31 * CaptureFile.VERSION + Corpus.sources(submission).hashCode()))

    /** The capture of [submission]. Throws [IllegalStateException] where it does not compile or does not start. May be called by several threads. */
    fun of(submission: Submission): Path {
        val capture = file(submission)
        if (capture.exists()) return capture
        val place = createTempDirectory(work, submission.name)
        try {
            Corpus.materialize(submission, place)
            val sources = Corpus.sources(submission).filterKeys { it.endsWith(".kt") }
            val log = run(place, main(sources), compiled(sources), place.resolve("capture"))
            check(place.resolve("capture").exists()) { "${submission.name} left no capture:\n$log" }
            folder.listDirectoryEntries("${submission.name}~*.capture").forEach { it.deleteExisting() }
            place.resolve("capture").moveTo(capture, overwrite = true)
            return capture
        } finally {
            place.toFile().deleteRecursively()
        }
    }

    private fun main(sources: Map<String, String>): String {
        val (path, text) = sources.entries.single { "fun main(" in it.value }
        val name = Regex("(?m)^package ([\\w.]+)").find(text)?.groupValues?.get(1).orEmpty()
        return "$name.${path.substringAfterLast('/').removeSuffix(".kt")}Kt"
    }

    private fun compiled(sources: Map<String, String>): Path {
        val name = "classes-%08x".format(31 * CaptureFile.VERSION + sources.values.joinToString("\u0000").hashCode())
        val classes = folder.resolve(name)
        synchronized(compiling.getOrPut(name) { Any() }) {
            if (classes.exists()) return classes
            val staged = createTempDirectory(work, "sources")
            sources.entries.forEachIndexed { i, (path, code) ->
                val file = path.substringAfterLast('/')
                val text = if (file == "GameWindow.kt") StandIn(code).source() else code
                staged.resolve("$i").createDirectories().resolve(file).writeText(text)
            }
            val made = createTempDirectory(work, "classes")
            val complaints = Compiled.complaints(listOf(staged), made, listOf(worker))
            check(complaints.isEmpty()) { complaints }
            // Another process may have been quicker.
            if (!classes.exists()) made.moveTo(classes)
            return classes
        }
    }

    private fun run(place: Path, main: String, classes: Path, capture: Path): String {
        val start = place.toFile().walk().first { it.name == "assets" }.parentFile.toPath()
        val host = idle.poll() ?: CaptureHost(createTempDirectory(work, "host"), worker)
        return host.run(main, classes, start, capture).also { if (host.isSpent) host.close() else idle += host }
    }

    override fun close() {
        idle.forEach(CaptureHost::close)
        if (idle.isNotEmpty()) work.toFile().deleteRecursively()
    }

    companion object {
        /** `CGA_CORPUS_FOLDER`, or `build/corpus` of the project. */
        val home: Path
            get() = System.getenv("CGA_CORPUS_FOLDER")?.let(Path::of) ?: projectRoot.toPath().resolve("build/corpus")
    }
}

package cga.grading.corpus

import cga.grading.capture.WorkerFiles
import cga.grading.capture.WorkerRun
import cga.grading.submission.StandIn
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeText

/**
 * Captures of the corpus' submissions, run without a sandbox since they are our own: what the analysis is developed and judged with.
 * Submissions with the same Kotlin are compiled once. A capture that is there already is kept until the submission or the recorder changes.
 */
internal class CorpusCaptures(private val folder: Path) {
    private val worker = folder.createDirectories().resolve("worker.jar").also { WorkerFiles.writeJar(it) }
    private val recorder = worker.readBytes().contentHashCode()

    /** The capture of [submission]. Throws [IllegalStateException] where it does not compile or does not start. */
    fun of(submission: Submission): Path {
        val capture = folder.resolve("${submission.name}~%08x.capture".format(31 * recorder + Corpus.sources(submission).hashCode()))
        if (capture.exists()) return capture
        folder.listDirectoryEntries("${submission.name}~*.capture").forEach { it.deleteExisting() }
        val home = createTempDirectory(folder, submission.name)
        try {
            Corpus.materialize(submission, home)
            val log = run(home, compiled(sources(home)), capture)
            check(capture.exists()) { "${submission.name} left no capture:\n$log" }
            return capture
        } finally {
            home.toFile().deleteRecursively()
        }
    }

    private fun sources(home: Path): List<Path> = home.walk().filter { it.name.endsWith(".kt") }.sorted().toList()

    private fun compiled(sources: List<Path>): Path {
        val text = sources.associateWith { it.readText() }
        val classes = folder.resolve("classes-%08x".format(text.values.joinToString("\u0000").hashCode()))
        if (classes.exists()) return classes
        val staged = createTempDirectory(folder, "sources")
        for ((file, code) in text) {
            val isWindow = file.name == "GameWindow.kt"
            staged
                .resolve(
                    "${text.keys.indexOf(file)}",
                ).createDirectories()
                .resolve(file.name)
                .writeText(if (isWindow) StandIn(code).source() else code)
        }
        val complaints = Compiled.complaints(listOf(staged), classes, listOf(worker))
        staged.toFile().deleteRecursively()
        if (complaints.isNotEmpty()) classes.toFile().deleteRecursively()
        check(complaints.isEmpty()) { complaints }
        return classes
    }

    private fun run(home: Path, classes: Path, capture: Path): String {
        val main = sources(home).single { "fun main(" in it.readText() }
        val name = Regex("(?m)^package ([\\w.]+)").find(main.readText())?.groupValues?.get(1).orEmpty()
        val command = WorkerFiles.command(WorkerRun(listOf(classes), worker, "$name.${main.name.removeSuffix(".kt")}Kt", capture))
        val assets = home.walk().first { "assets" in it.toString().split('/') }.let { file ->
            generateSequence(file) { it.parent }.first {
                it.name ==
                    "assets"
            }
        }
        val log = folder.resolve("log-${home.name}.txt").toFile()
        val process = ProcessBuilder(command).directory(assets.parent.toFile()).redirectErrorStream(true).redirectOutput(log)
        process.environment().putAll(WorkerFiles.environment)
        val started = process.start()
        if (!started.waitFor(SECONDS, TimeUnit.SECONDS)) started.destroyForcibly()
        return log.readText().also { log.delete() }
    }

    private companion object {
        const val SECONDS = 120L
    }
}

package cga.grading.corpus

import cga.grading.capture.WorkerFiles
import cga.grading.worker.WorkerMain
import org.lwjgl.glfw.GLFW.glfwTerminate
import org.lwjgl.opengl.GL
import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.concurrent.thread
import kotlin.io.path.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.moveTo
import kotlin.io.path.readText

/**
 * A process that runs submissions one after the other, since they are our own: its start takes longer than a run.
 *
 * @param home its working folder, where the submission's `assets` and `shaders` are put.
 */
internal class CaptureHost(
    private val home: Path,
    worker: Path,
) : AutoCloseable {
    private val log = home.createDirectories().resolve("log.txt")
    private val process: Process
    private var runs = 0

    /** Whether it has run so many that its memory is better given back. */
    val isSpent: Boolean get() = runs >= MOST_RUNS || !process.isAlive

    init {
        val own = Path.of(CaptureHost::class.java.protectionDomain.codeSource.location.toURI())
        val classPath = (WorkerFiles.own(worker) + listOf(own)).joinToString(File.pathSeparator)
        val java = Path(System.getProperty("java.home"), "bin", "java").toString()
        val command = listOf(java) + WorkerFiles.FLAGS + listOf("-Xmx1536m", "-cp", classPath, "cga.grading.corpus.CaptureHostKt")
        val builder = ProcessBuilder(command).directory(home.toFile()).redirectError(log.toFile())
        builder.environment() += WorkerFiles.environment
        process = builder.start()
    }

    /** Runs the class [main] of [classes] in [start], whose `assets` and `shaders` are moved away; what it said where it leaves no [capture]. */
    fun run(
        main: String,
        classes: Path,
        start: Path,
        capture: Path,
    ): String {
        runs++
        for (folder in listOf("assets", "shaders")) {
            home.resolve(folder).toFile().deleteRecursively()
            if (start.resolve(folder).exists()) start.resolve(folder).moveTo(home.resolve(folder))
        }
        val watch = thread(isDaemon = true) { if (!sleptUntilDone()) process.destroyForcibly() }
        val said = StringBuilder()
        process.outputStream.run { write("$main\t$capture\t$classes\n".toByteArray()).also { flush() } }
        val lines = process.inputReader()
        while (true) {
            val line = lines.readLine() ?: break
            if (line == DONE) break
            said.appendLine(line)
        }
        watch.interrupt()
        return "$said${log.readText()}"
    }

    private fun sleptUntilDone() =
        try {
            Thread.sleep(SECONDS.toMillis(LIMIT))
            false
        } catch (_: InterruptedException) {
            true
        }

    override fun close() {
        process.destroyForcibly()
    }

    companion object {
        const val DONE = "\u0001done"
        private const val MOST_RUNS = 20
        private const val LIMIT = 120L
    }
}

/** Runs what is said on standard input, a line each: the class, the file for its capture, and where its classes are. */
fun main() {
    for (line in generateSequence(::readlnOrNull)) {
        val (main, capture, classes) = line.split('\t')
        WorkerMain.run(main, Path(capture), listOf(Path(classes)))
        glfwTerminate()
        GL.destroy()
        println("\n${CaptureHost.DONE}")
    }
}

package cga.grading.worker

import cga.grading.capture.Capture
import cga.grading.capture.CaptureFile
import cga.grading.capture.EventKind
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path

/** The run of a submission in this JVM, and the file that its capture goes to. */
internal object Session {
    private var tape = Tape()
    private var file: Path? = null
    private var isWritten = false
    private var isClaimed = false

    /** Has the capture written to [file], at the latest when the JVM goes down: by `System.exit`, or by a signal that it can hear. */
    @Synchronized
    fun begin(file: Path) {
        if (this.file == null) Runtime.getRuntime().addShutdownHook(Thread(::finish))
        this.file = file
        tape = Tape()
        isWritten = false
        isClaimed = false
    }

    /** The tape for the one window that there may be. */
    @Synchronized
    fun claim(): Tape {
        check(!isClaimed) { "a second window cannot be opened" }
        isClaimed = true
        return tape
    }

    /** Notes that the submission threw [problem]; the same only once. */
    fun fail(problem: Throwable) {
        tape.event(EventKind.EXCEPTION, describe(problem))
    }

    /** No capture is to be written. */
    @Synchronized
    fun abandon() {
        isWritten = true
    }

    /** Writes what has been captured, once. */
    @Synchronized
    fun finish() {
        val file = file ?: return
        if (isWritten) return
        isWritten = true
        try {
            noteFiles()
            CaptureFile.write(named(tape.capture()), file)
        } catch (e: IOException) {
            System.err.println("the capture cannot be written: $e")
        }
    }

    /** A help to tell textures apart: no capture fails for want of it. */
    private fun noteFiles() {
        try {
            val folder = Path.of("assets").takeIf { Files.isDirectory(it) } ?: return
            val read = TextureFiles.of(tape.capture(), folder)
            for ((number, name) in read) tape.event(EventKind.TEXTURE_FILE, "$number $name")
            for (name in TextureFiles.others(folder, read.values)) tape.event(EventKind.TEXTURE_FILE, "- $name")
        } catch (e: IOException) {
            System.err.println("the textures' files cannot be read: $e")
        } catch (e: UncheckedIOException) {
            System.err.println("the textures' files cannot be read: $e")
        } catch (e: LinkageError) {
            System.err.println("the textures' files cannot be read: $e")
        }
    }

    private fun named(capture: Capture): Capture =
        try {
            val files = ShaderFiles(Path.of(""))
            capture.with(programs = capture.programs.map(files::named))
        } catch (e: IOException) {
            capture.also { System.err.println("the shaders' files cannot be read: $e") }
        } catch (e: UncheckedIOException) {
            capture.also { System.err.println("the shaders' files cannot be read: $e") }
        }

    private fun describe(problem: Throwable): String =
        generateSequence(problem) { it.cause.takeIf { cause -> cause !== it } }.take(MAX_CAUSES).joinToString("\ncaused by ") { link ->
            val own = link.stackTrace.filterNot { frame -> FOREIGN.any { frame.className.startsWith(it) } }.take(MAX_LINES)
            (listOf("$link".take(MAX_MESSAGE)) + own.map { "  at $it" }).joinToString("\n")
        }

    private const val MAX_CAUSES = 4
    private const val MAX_LINES = 8
    private const val MAX_MESSAGE = 500
    private val FOREIGN = listOf("java.", "javax.", "jdk.", "sun.", "kotlin.", "org.lwjgl.", "cga.grading.")
}

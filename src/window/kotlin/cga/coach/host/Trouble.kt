package cga.coach.host

import cga.coach.ui.say
import cga.framework.ShaderComplaint
import cga.framework.ShaderLog
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText

/**
 * Something that goes wrong with the student's program, to be shown in the window.
 *
 * @param title in a few words.
 * @param lines what is to be read, from top to bottom; indented ones are source code.
 * @param cure what becomes of it, or what to do.
 */
internal class Trouble(
    val title: String,
    val lines: List<String>,
    val cure: String,
) {
    /** All of it, for the terminal. */
    val text: String get() = (listOf(title) + lines + cure).joinToString("\n")

    companion object {
        private const val INDENT = "    "
        private const val MOST_FRAMES = 4

        val AGAIN: String get() = say(
            "Mend it and save: it is read by itself.",
            "Verbessern und speichern: Es wird von selbst neu gelesen.",
        )
        val OLD_STAYS: String get() = say("What ran before goes on. ", "Was vorher lief, läuft weiter. ") + AGAIN
        val PICTURE_STAYS: String get() = say("The last good picture stays. ", "Das letzte gute Bild bleibt. ") + AGAIN

        /** The compiler's [messages]. */
        fun ofCompiler(
            messages: List<String>,
            cure: String,
        ): Trouble = Trouble(say("Kotlin does not compile", "Kotlin lässt sich nicht übersetzen"), messages, cure)

        /** [problem] was thrown in [where]; [isTheirs] tells the student's classes. */
        fun of(
            problem: Throwable,
            where: String,
            cure: String,
            isTheirs: (String) -> Boolean,
        ): Trouble {
            val cause = generateSequence(problem) { it.cause }.last()
            val frames = cause.stackTrace.filter { isTheirs(it.className) && it.lineNumber > 0 }.take(MOST_FRAMES)
            val first = frames.firstOrNull()
            val lines = buildList {
                add("${cause.javaClass.simpleName}: ${cause.message ?: say("no message", "ohne Text")}".take(LONGEST))
                if (first != null) {
                    add("${first.fileName}:${first.lineNumber}")
                    SourceFiles.line(first)?.let { add(INDENT + it.trim()) }
                }
                frames.drop(1).forEach { add(say("called by", "aufgerufen von") + " ${it.fileName}:${it.lineNumber}") }
            }
            return Trouble("Exception: $where", lines, cure)
        }

        /** A shader that the driver refuses: [log] is what it says of [source]. */
        fun ofShader(
            source: String,
            log: String,
            cure: String,
        ): Trouble {
            val file = SourceFiles.shaderNamed(source)
            val text = source.lines()
            val lines = ShaderLog.read(text, log).flatMap { lines(file, text, it) }
            return Trouble(say("The shader does not compile", "Der Shader lässt sich nicht übersetzen"), lines, cure)
        }

        private fun lines(
            file: String,
            text: List<String>,
            complaint: ShaderComplaint,
        ): List<String> {
            fun source(line: Int) = text.getOrNull(line - 1)?.let { INDENT + it.trim() }
            val line = complaint.line ?: return listOf("$file: ${complaint.message}")
            val before = complaint.unended ?: return listOfNotNull("$file:$line: ${complaint.message}", source(line))
            val or =
                say(
                    "or already line $before, which does not end in a semicolon:",
                    "oder schon Zeile $before, an deren Ende kein Semikolon steht:",
                )
            return listOfNotNull("$file:$line: ${complaint.message}", source(line), or, source(before))
        }

        private const val LONGEST = 600
    }
}

/** The student's files, by what is known of them. */
internal object SourceFiles {
    private val FOLDERS = listOf("src", "shaders", "assets")
    private val SHADERS = setOf("glsl", "vert", "frag", "vs", "fs", "vsh", "fsh")

    /** The line of source that [frame] stands at. */
    fun line(frame: StackTraceElement): String? {
        val name = frame.fileName ?: return null
        val folder = frame.className.substringBeforeLast('.', "").replace('.', '/')
        val files = files().filter { it.name == name }
        val file = files.firstOrNull { "$it".replace('\\', '/').endsWith("$folder/$name") } ?: files.firstOrNull() ?: return null
        return file.readLines().getOrNull(frame.lineNumber - 1)
    }

    /** The file that holds the shader [source]. */
    fun shaderNamed(source: String): String {
        val text = plain(source)
        return files().firstOrNull { it.extension.lowercase() in SHADERS && plain(it.readText()) == text }?.toString()?.replace('\\', '/')
            ?: say("the shader", "der Shader")
    }

    private fun plain(text: String) = text.replace("\r\n", "\n").trim()

    private fun files(): List<Path> =
        FOLDERS.map(Path::of).filter(Files::exists).flatMap { folder ->
            Files.walk(folder).use { paths -> paths.filter { it.isRegularFile() }.toList() }
        }
}

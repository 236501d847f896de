package cga.coach.host

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

        val AGAIN: String get() = say("Mend it and save: it is read by itself.", "Verbessern und speichern: Es wird von selbst neu gelesen.")
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
            val lines = ShaderLog.explain(SourceFiles.shaderNamed(source), source, log)
            return Trouble(say("The shader does not compile", "Der Shader lässt sich nicht übersetzen"), lines, cure)
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

/** Reads the logs of OpenGL's compilers. */
internal object ShaderLog {
    // Mesa "0:12(5): error: …", NVIDIA "0(12) : error …", AMD, Intel and Apple "ERROR: 0:12: …".
    private val LOCATION = Regex("""^(?:(?:ERROR|WARNING):\s*)?\d+[:(](\d+)\)?(?:\((\d+)\))?\s*:\s*(.*)$""")

    /** The [log] about the shader [source] in [file] as lines `file:line: message`, each with its source below. */
    fun explain(
        file: String,
        source: String,
        log: String,
    ): List<String> {
        val text = source.lines()
        return log.trim().lines().filter(String::isNotBlank).flatMap { entry ->
            val (line, _, message) = LOCATION.find(entry.trim())?.destructured ?: return@flatMap listOf("$file: ${entry.trim()}")
            val number = line.toInt()
            listOfNotNull("$file:$number: $message", text.getOrNull(number - 1)?.let { "    ${it.trim()}" }) + before(text, number, message)
        }
    }

    /** Where a semicolon is missing, compilers name the line after: the one before is shown as well. */
    private fun before(
        text: List<String>,
        number: Int,
        message: String,
    ): List<String> {
        if ("syntax error" !in message) return emptyList()
        val last = (number - 2 downTo 0).firstOrNull { text[it].substringBefore("//").isNotBlank() } ?: return emptyList()
        val code = text[last].substringBefore("//").trimEnd()
        if (code.last() in ";{},(" || code.startsWith("#")) return emptyList()
        return listOf(
            say("or already line ${last + 1}, which has no ; at its end:", "oder schon Zeile ${last + 1}, an deren Ende kein ; steht:"),
            "    ${text[last].trim()}",
        )
    }
}

package cga.measure

import cga.framework.AtomicFile
import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Path
import kotlin.io.path.writeText

/**
 * A document whose text is written by hand and whose figures are not: what stands between a line `<!-- NAME -->` and the next line
 * `<!-- end -->` is replaced, and nothing else.
 */
public class MarkedDocument private constructor(
    private val file: Path,
    private val text: String,
) {
    /** The document with [content] at [marker] ("table:choices"). Throws [InputError] where it has no such marker, or no end after it. */
    public fun with(
        marker: String,
        content: String,
    ): MarkedDocument {
        val lines = text.lines()
        val start = line(lines, marker)
        val end = end(lines, start)
        val filled = lines.subList(0, start + 1) + "" + content.trim().lines() + "" + lines.subList(end, lines.size)
        return MarkedDocument(file, filled.joinToString("\n"))
    }

    /** Throws [InputError] unless the document has [marker], and its end. */
    public fun require(marker: String) {
        val lines = text.lines()
        end(lines, line(lines, marker))
    }

    /** Replaces the file, whole or not at all. */
    public fun write(): Unit = AtomicFile.write(file) { it.writeText(text) }

    private fun line(
        lines: List<String>,
        marker: String,
    ): Int {
        val found = lines.indices.filter { lines[it].trim() == "<!-- $marker -->" }
        if (found.size == 1) return found[0]
        throw InputError(
            "$file has the line <!-- $marker --> ${found.size} times: put it where the figures go, once, and <!-- end --> below.",
        )
    }

    private fun end(
        lines: List<String>,
        start: Int,
    ): Int {
        val next = (start + 1 until lines.size).firstOrNull { MARKER.matches(lines[it].trim()) }
        if (next != null && lines[next].trim() == "<!-- end -->") return next
        throw InputError("$file:${start + 1}: ${lines[start].trim()} has no end: put a line <!-- end --> where its figures end.")
    }

    public companion object {
        private val MARKER = Regex("<!-- (end|(table|plot):.*) -->")

        /** Reads [file]. Throws [InputError] where it cannot be read or written. */
        public fun read(file: Path): MarkedDocument {
            AtomicFile.checkWritable(file)
            return MarkedDocument(file, Home.read(file, "document").decodeToString().replace("\r\n", "\n"))
        }
    }
}

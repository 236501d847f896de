package cga.exercise.components.shader

import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString

/**
 * The text of a shader with its includes: a line `#include "name"` becomes the lines of that file, which lies beside the one that includes
 * it, once in a shader however often it is asked for. Every line keeps its place in its own file, for the compiler's messages.
 */
public class ShaderSource private constructor(
    internal val path: String,
    private val lines: List<Line>,
) {
    /** What the compiler is given. */
    public val text: String = lines.joinToString("\n") { it.text }

    /** Line [number] of [text], counted from 1; null where there is none. */
    internal fun line(number: Int): Line? = lines.getOrNull(number - 1)

    /** A line of [file], its [number] there counted from 1. */
    internal class Line(
        val file: String,
        val number: Int,
        val text: String,
    )

    public companion object {
        private val INCLUDE = Regex("""\s*#include\s+"([^"]+)"\s*""")

        /**
         * The file at [path] (see [Home]), with the numbers of [constants] in the place of those in its `const int NAME = …;` lines. Throws
         * [InputError] when it, or a file that it includes, cannot be read.
         */
        public fun read(
            path: String,
            constants: Map<String, Int> = emptyMap(),
        ): ShaderSource = ShaderSource(path, expand(path, HashSet()).map { Line(it.file, it.number, replaced(it.text, constants)) })

        /** [text] as if it was the file at [path] and included nothing. */
        internal fun of(
            path: String,
            text: String,
        ): ShaderSource = ShaderSource(path, lines(path, text))

        private fun lines(
            path: String,
            text: String,
        ) = text.lines().mapIndexed { i, line -> Line(path, i + 1, line) }

        private fun expand(
            path: String,
            included: MutableSet<String>,
        ): List<Line> {
            included += path
            return lines(path, String(Home.read(path, "shader"))).flatMap { line ->
                val name = INCLUDE.matchEntire(line.text)?.groupValues?.get(1)
                if (name == null) listOf(line) else include(line, name, included)
            }
        }

        private fun include(
            line: Line,
            name: String,
            included: MutableSet<String>,
        ): List<Line> {
            val file = Path.of(line.file).resolveSibling(name).normalize().invariantSeparatorsPathString
            if (file in included) return emptyList()
            try {
                return expand(file, included).dropLastWhile { it.text.isEmpty() }
            } catch (e: InputError) {
                throw InputError("${line.file}:${line.number} includes $name: ${e.message}", e)
            }
        }

        private fun replaced(
            line: String,
            constants: Map<String, Int>,
        ): String =
            constants.entries.fold(line) { text, (name, value) -> text.replace(Regex("""(?<=\bconst int $name = )\d+(?=;)"""), "$value") }
    }
}

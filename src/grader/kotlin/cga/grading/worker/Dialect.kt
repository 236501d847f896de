package cga.grading.worker

/**
 * GLSL that some drivers accept although the specification has it otherwise, said again as it should be. What it computes stays the same.
 * docs/grading.md lists what is covered, and how it is known that a driver accepts it.
 */
internal object Dialect {
    /** [source] said otherwise, the least change first; none of them is [source] itself. */
    fun of(source: String): List<String> {
        val plain = source.removePrefix("\uFEFF")
        val headed = headed(plain)
        val strict = Strict(GlslTokens.of(headed)).tokens.text()
        return listOf(plain, headed, strict, extended(strict)).distinct() - source
    }

    /** With `#version` in the first line, where it has to be, and of a profile that there is. */
    private fun headed(source: String): String {
        val lines = source.lines()
        val head = lines.indexOfFirst { it.trimStart().removePrefix("#").trimStart().startsWith("version") && '#' in it }
        if (head < 0) return "#version 330 core\n$source"
        return (listOf(version(lines[head])) + lines.take(head) + lines.drop(head + 1)).joinToString("\n")
    }

    private fun version(line: String): String {
        val words = line.substringAfter("version").trim()
        val number = words.takeWhile { it.isDigit() }
        val profile = words.drop(number.length).trim().takeWhile { it.isLetter() }.lowercase()
        return "#version $number" + if (profile in PROFILES) " $profile" else ""
    }

    /** With what later versions took over, which some drivers know in 3.30 as well: initialisers in braces, layouts. */
    private fun extended(source: String): String =
        source.lineSequence().first() + "\n" + EXTENSIONS.joinToString("") { "#extension $it : enable\n" } + source.substringAfter('\n', "")

    private val PROFILES = setOf("core", "es")
    private val EXTENSIONS =
        listOf("GL_ARB_shading_language_420pack", "GL_ARB_explicit_uniform_location") +
            listOf("GL_ARB_separate_shader_objects", "GL_ARB_gpu_shader5")
}

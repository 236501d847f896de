package cga.grading.worker

/**
 * GLSL that some drivers accept although the specification has it otherwise, said again as it should be. What it computes stays the same.
 */
internal object Dialect {
    /** [source] said otherwise, the least change first; none of them is [source] itself. */
    fun of(source: String): List<String> {
        val headed = headed(source.removePrefix("\uFEFF"))
        return listOf(source.removePrefix("\uFEFF"), headed, extended(headed)).distinct() - source
    }

    /** With `#version` in the first line, where it has to be. */
    private fun headed(source: String): String {
        val lines = source.lines()
        val head = lines.indexOfFirst { VERSION.containsMatchIn(it) }
        if (head < 0) return "#version 330 core\n$source"
        return (listOf(lines[head].trim()) + lines.take(head) + lines.drop(head + 1)).joinToString("\n")
    }

    /** With what later versions took over, which some drivers know in 3.30 as well: initialisers in braces, layouts. */
    private fun extended(source: String): String =
        source.lineSequence().first() + "\n" + EXTENSIONS.joinToString("") { "#extension $it : enable\n" } + source.substringAfter('\n', "")

    private val VERSION = Regex("""^\s*#\s*version\b""")
    private val EXTENSIONS =
        listOf("GL_ARB_shading_language_420pack", "GL_ARB_explicit_uniform_location") +
            listOf("GL_ARB_separate_shader_objects", "GL_ARB_gpu_shader5")
}

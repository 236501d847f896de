package cga.grading.study

/**
 * GLSL whose constant vectors have become uniforms, so that a colour or a position written into a shader can be changed like any other.
 *
 * @param source what to compile.
 * @param values of the uniforms that stand for constants, by name.
 * @param texts what the submission wrote there, by the same names.
 * @param deep names of uniforms that multiply vectors which are no constants; their values are 1.
 */
internal class LiftedConstants(
    val source: String,
    val values: Map<String, FloatArray>,
    val texts: Map<String, String>,
    val deep: List<String> = emptyList(),
) {
    companion object {
        /**
         * Lifts each `vec3(…)` and `vec4(…)` of nothing but numbers in [source], black ones apart; [prefix] begins the new names.
         * Comments are blanked on the way, which keeps the line numbers. [isDeep] lifts other vectors as well, see [DeepLift].
         */
        fun of(
            source: String,
            prefix: String,
            isDeep: Boolean = false,
        ): LiftedConstants {
            val values = LinkedHashMap<String, FloatArray>()
            val texts = LinkedHashMap<String, String>()
            val lifted =
                CONSTRUCTOR.replace(withoutComments(source)) { match ->
                    val name = "$prefix${values.size}"
                    val numbers = match.groupValues[2].split(',').map { it.trim().trimEnd('f', 'F').toFloat() }
                    val size = match.groupValues[1].toInt()
                    if (numbers.size != 1 && numbers.size != size) return@replace match.value
                    // Black is where a sum begins and what a branch without light returns: no colour of anything.
                    if (numbers.take(3).all { it == 0f }) return@replace match.value
                    values[name] = FloatArray(size) { numbers[if (numbers.size == 1) 0 else it] }
                    texts[name] = match.value.replace(Regex("\\s+"), "")
                    name
                }
            val free = CONST.replace(lifted, "")
            val deep = if (isDeep) DeepLift.of(free, "${prefix}m") else DeepLift(free, emptyList())
            val declarations = values.map { "uniform vec${it.value.size} ${it.key};" } + deep.names.map { "uniform vec3 $it;" }
            val ones = deep.names.associateWith { FloatArray(3) { 1f } }
            return LiftedConstants(afterVersion(deep.source, declarations.joinToString(" ")), values + ones, texts, deep.names)
        }

        /** [source] with [text] on a line of its own behind the #version line and the #extension lines. */
        fun afterVersion(
            source: String,
            text: String,
        ): String {
            if (text.isEmpty()) return source
            val at = HEAD.findAll(source).lastOrNull()?.let { it.range.last + 1 } ?: 0
            return source.substring(0, at) + (if (at > 0) "\n" else "") + text + "\n" + source.substring(at)
        }

        /** [source] with spaces in the place of its comments. */
        fun withoutComments(source: String): String =
            COMMENT.replace(source) { match -> match.value.map { if (it == '\n') '\n' else ' ' }.joinToString("") }

        private const val NUMBER = """[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fF]?"""
        private val CONSTRUCTOR = Regex("""\bvec([34])\s*\(\s*($NUMBER(?:\s*,\s*$NUMBER)*)\s*\)""")

        // A constant that is made of uniforms is none; those that may size an array stay.
        private val CONST = Regex("""\bconst\s+(?=(?:(?:lowp|mediump|highp)\s+)?(?!u?int\b|bool\b|in\b)\w)""")
        private val HEAD = Regex("""(?m)^[ \t]*#[ \t]*(?:version|extension)[^\n]*$""")
        private val COMMENT = Regex("""//[^\n]*|/\*[\s\S]*?\*/""")
    }
}

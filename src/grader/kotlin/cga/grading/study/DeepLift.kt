package cga.grading.study

/**
 * GLSL in which vectors that the shader makes itself are multiplied by uniforms, 1 as long as nobody changes them: the colour of a light
 * that is sent as three numbers, or computed from the time.
 *
 * @param source what to compile; its declarations are not in it yet.
 * @param names of the uniforms, all of them `vec3`.
 */
internal class DeepLift(
    val source: String,
    val names: List<String>,
) {
    companion object {
        /** Multiplies each `vec3(a, b, c)` and each `vec3 name = …;` in [source], without comments; [prefix] begins the new names. */
        fun of(
            source: String,
            prefix: String,
        ): DeepLift {
            val names = mutableListOf<String>()

            fun next() = "$prefix${names.size}".also(names::add)
            val constructors = constructors(source, ::next)
            val all =
                INITIALIZER.replace(constructors) { match ->
                    val value = match.groupValues[2]
                    if (commas(value) > 0 || names.size >= MOST) match.value else "${match.groupValues[1]}${next()} * ($value);"
                }
            return DeepLift(all, names)
        }

        private fun constructors(
            source: String,
            next: () -> String,
        ): String {
            val result = StringBuilder()
            var at = 0
            for (match in CONSTRUCTOR.findAll(source)) {
                if (match.range.first < at) continue
                val end = closing(source, match.range.last) ?: continue
                if (commas(source.substring(match.range.last + 1, end)) != 2) continue
                result.append(source, at, match.range.first).append("(${next()} * ").append(source, match.range.first, end + 1).append(")")
                at = end + 1
            }
            return result.append(source, at, source.length).toString()
        }

        /** Where the bracket that opens at [open] is closed. */
        private fun closing(
            source: String,
            open: Int,
        ): Int? {
            var depth = 0
            for (i in open until source.length) {
                if (source[i] == '(') depth++
                if (source[i] == ')' && --depth == 0) return i
            }
            return null
        }

        /** How many commas of [text] are in no bracket. */
        private fun commas(text: String): Int {
            var depth = 0
            return text.count { c ->
                if (c in "([{") depth++
                if (c in ")]}") depth--
                c == ',' && depth == 0
            }
        }

        private const val MOST = 48
        private val CONSTRUCTOR = Regex("""\bvec3\s*\(""")

        // Not the default of a uniform, and no condition of a loop.
        private val INITIALIZER = Regex("""((?<!uniform )\bvec3\s+\w+\s*=\s*)([^;{}]+);""")
    }
}

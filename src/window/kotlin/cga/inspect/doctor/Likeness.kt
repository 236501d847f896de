package cga.inspect.doctor

import cga.exercise.components.shader.UniformNames

/** How alike two names are. */
internal object Likeness {
    /** Below 1/3 so many letters in one differ; 0.4 where only a word is the same, as in `tint` and `emissiveTint`; 1 for nothing in common. */
    fun distance(
        a: String,
        b: String,
    ): Double {
        // What both begin with says nothing: of `light.color` and `light.colour` the members are compared.
        val (left, right) = withoutCommonPrefix(a, b)
        val letters = UniformNames.distance(left, right).toDouble() / maxOf(left.length, right.length, 1)
        return if (letters <= SLIP || words(left).none { it in words(right) }) letters.coerceAtMost(1.0) else SAME_WORD
    }

    private fun withoutCommonPrefix(
        a: String,
        b: String,
    ): Pair<String, String> {
        val prefix = a.substringBeforeLast('.', "")
        return if (prefix.isNotEmpty() && b.startsWith("$prefix.")) a.removePrefix("$prefix.") to b.removePrefix("$prefix.") else a to b
    }

    private fun words(name: String) =
        name.split(Regex("""[._]|(?<=[a-z])(?=[A-Z])""")).map(String::lowercase).filter { it.length >= SHORTEST }.toSet()

    private const val SLIP = 1.0 / 3
    private const val SAME_WORD = 0.4
    private const val SHORTEST = 3
}

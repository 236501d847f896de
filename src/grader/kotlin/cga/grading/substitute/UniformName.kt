package cga.grading.substitute

/** What a number sent to a shader may be to a light, and the words that say so in English and German. */
internal enum class Part(
    private vararg val words: String,
) {
    INNER("inner", "innen", "phi"),
    OUTER("outer", "aussen", "außen", "gamma"),
    CONSTANT("constant", "const", "kc"),
    LINEAR("linear", "lin", "kl"),
    QUADRATIC("quadratic", "quadr", "quad", "kq"),
    DIRECTION("direction", "dir", "richtung", "axis", "achse", "forward"),
    POSITION("position", "pos", "ort", "origin", "location", "place"),
    COLOR("colour", "color", "col", "farbe", "farb", "rgb", "intensity"),
    ATTENUATION(
        "attenuation", "atten", "att", "falloff", "coefficient", "coeff", "factor", "k",
        "abschwächung", "abschwaechung", "daempfung", "dämpfung", "abfall",
    ),
    CONE("cone", "angles", "angle", "winkel", "cutoff", "cut", "off", "kegel", "cosine", "cos", "theta"),
    ;

    /** What is left of [token] without the word that names this part; null where none does. */
    fun without(token: String): String? =
        words.firstNotNullOfOrNull { word ->
            listOf(word, word + "s").firstNotNullOfOrNull { form ->
                when {
                    token == form -> ""
                    form.length < SHORTEST -> null
                    token.endsWith(form) -> token.removeSuffix(form)
                    token.startsWith(form) && token.drop(form.length).all(Char::isDigit) -> token.removePrefix(form)
                    else -> null
                }
            }
        }

    private companion object {
        /** Of a word that may be one half of another. */
        const val SHORTEST = 3
    }
}

/**
 * The name of a uniform, taken apart: `pointLight[1].attColor` is the [Part.COLOR] of `point1`.
 *
 * @property parts all that its words say, most telling first.
 * @property owner the words that are left: the same for all parts of a light.
 */
internal class UniformName(
    val name: String,
) {
    val parts: List<Part>
    val owner: String

    init {
        val found = sortedSetOf<Part>()
        owner =
            tokens(name).joinToString("") { token ->
                val part = Part.entries.firstOrNull { it.without(token) != null }
                if (part != null) found += part
                (part?.without(token) ?: token).takeUnless { it in FILLERS }.orEmpty()
            }
        parts = found.toList()
    }

    /** Whether it is one of the numbers of a cone. */
    val isCone: Boolean get() = parts.any { it == Part.INNER || it == Part.OUTER || it == Part.CONE }

    /** Whether one of its words begins with one of [words]. */
    fun says(words: List<String>): Boolean = tokens(name).any { token -> words.any { token.startsWith(it) } }

    fun says(vararg words: String): Boolean = says(words.toList())

    private companion object {
        val BORDER = Regex("""(?<=[a-zäöü0-9])(?=[A-ZÄÖÜ])|[^\p{L}\d]+""")
        val FILLERS = setOf("light", "lights", "licht", "lichter", "lamp", "u", "uniform", "source", "quelle", "vec", "value")

        fun tokens(name: String): List<String> = name.split(BORDER).filter { it.isNotEmpty() }.map { it.lowercase() }
    }
}

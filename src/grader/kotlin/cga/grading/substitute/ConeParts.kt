package cga.grading.substitute

import kotlin.math.PI

/**
 * The two numbers of a cone.
 *
 * @param inner GLSL for the cosine of the narrower angle, [outer] for that of the wider one.
 */
internal class ConeParts private constructor(
    val inner: String,
    val outer: String,
) {
    companion object {
        /**
         * Of the [numbers] of one light, with their values; null where there are none, or where they leave out no direction. Which of two
         * is meant to be the narrower only the shader could tell: so it is the one that is.
         */
        fun of(numbers: List<Pair<UniformName, FloatArray>>): ConeParts? {
            val sent = chosen(numbers)
            val values = sent.map { it.second }
            if (sent.isEmpty() || values.any(::isEverywhere)) return null
            // Angles, unless the first is larger: so are cosines, the first being that of the narrower angle.
            val areCosines = sent.size == 2 && values.all { it in 0f..1f } && values[0] > values[1]
            val cosines = sent.sortedBy { if (areCosines) -it.second else it.second }.map { (text, _) ->
                when {
                    areCosines -> text
                    values.max() > PI / 2 -> "cos(radians($text))"
                    else -> "cos($text)"
                }
            }
            return ConeParts(if (cosines.size == 2) cosines[0] else "(${cosines[0]} + $EDGE)", cosines.last())
        }

        /** GLSL for the numbers that are meant, with their values: both of a pair, the two by name, or what there is. */
        private fun chosen(numbers: List<Pair<UniformName, FloatArray>>): List<Pair<String, Float>> {
            numbers.find { it.second.size == 2 }?.let { (pair, values) ->
                return listOf("${pair.name}.x" to values[0], "${pair.name}.y" to values[1])
            }
            val outer = numbers.find { Part.OUTER in it.first.parts }
            val inner = numbers.find { Part.INNER in it.first.parts } ?: numbers.find { it != outer }
            return listOfNotNull(inner, outer).map { (name, value) -> name.name to value[0] }
        }

        /** A cosine that no angle is below, or half a circle or more to each side. */
        private fun isEverywhere(number: Float) = number <= -1f || number in NEARLY_PI..2 * NEARLY_PI || number >= HALF_CIRCLE

        /** How wide an edge is where one angle is sent; as a cosine. */
        private const val EDGE = 1e-3
        private const val NEARLY_PI = 3.14f
        private const val HALF_CIRCLE = 180f
    }
}

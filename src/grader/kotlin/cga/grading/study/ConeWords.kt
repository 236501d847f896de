package cga.grading.study

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.cos
import kotlin.math.round

/** How a number that was sent becomes the cosine of a cone's edge. */
internal enum class AngleForm {
    ANGLE,
    COSINE,
    VERSINE,
    HALF_ANGLE,
    COSINE_TWICE,
    DEGREES,
    ;

    /** The cosine that the shader makes of [sent]. */
    fun cosine(sent: Double): Double =
        when (this) {
            ANGLE -> cos(sent)
            COSINE -> sent
            VERSINE -> 1 - sent
            HALF_ANGLE -> cos(sent / 2)
            COSINE_TWICE -> cos(cos(sent))
            DEGREES -> cos(Math.toRadians(sent))
        }
}

/**
 * The numbers that were sent for the two edges of a cone.
 *
 * @param full value for the edge of full light, [dark] for that of darkness.
 */
internal class ConeWords(
    val form: AngleForm,
    val full: Double,
    val dark: Double,
) {
    companion object {
        /** Finds two of [numbers] that make the edges [cosFull] and [cosDark] in the same way; null where none do. */
        fun of(
            cosFull: Double,
            cosDark: Double,
            numbers: Collection<Double>,
        ): ConeWords? {
            // Edges of a narrow cone are nearer to each other than two roundings.
            val near = minOf(NEAR, abs(cosFull - cosDark) / 20)
            for (form in AngleForm.entries) {
                val full = numbers.firstOrNull { abs(form.cosine(it) - cosFull) < near } ?: continue
                val dark = numbers.firstOrNull { it != full && abs(form.cosine(it) - cosDark) < near } ?: continue
                return ConeWords(form, full, dark)
            }
            return null
        }

        /** Whether an angle of [radians] looks chosen: a multiple of half a degree, or of a hundredth of a radian. */
        fun isRound(radians: Double): Boolean = isMultiple(Math.toDegrees(radians), 0.5) || isMultiple(radians, 0.01)

        /** Whether both effective angles are what the cosine of a round number of *degrees* gives when taken for radians. */
        fun areDegreesInRadians(
            first: Double,
            second: Double,
        ): Boolean = listOf(first, second).all { angle ->
            (1..ROUNDS).any { n ->
                isMultiple(2 * PI * n + angle, 0.5) ||
                    isMultiple(2 * PI * n - angle, 0.5)
            }
        }

        fun isRoundCosine(value: Double): Boolean = value > 0 && value < 1 && isMultiple(Math.toDegrees(acos(value)), 0.5)

        private fun isMultiple(
            x: Double,
            unit: Double,
        ) = abs(x / unit - round(x / unit)) * unit < 1e-4

        // A cosine of floats, and an edge found on a curve of floats: both good to some 1e-6.
        private const val NEAR = 2e-5
        private const val ROUNDS = 14
    }
}

package cga.imaging.flip

import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min
import kotlin.math.pow
import kotlin.math.sqrt

/** The ꟻLIP error of one pixel of two filtered rows (sections 4.1 to 4.3 of the 2020 paper). */
internal object PixelError {
    private const val COLOR_EXPONENT = 0.7

    /** Color differences up to this share of the largest one make up the error's range up to [KNEE_ERROR]. */
    private const val KNEE = 0.4
    private const val KNEE_ERROR = 0.95
    private const val SQRT_HALF = 0.70710678f

    /** From green to blue: the farthest that two colours on a screen are apart. */
    private val farthest: Double = run {
        val colors = ColorRow(2)
        colors.second[0] = 1f
        colors.third[1] = 1f
        ColorSpace.linearToOpponent(colors)
        ColorSpace.opponentToHuntLab(colors)
        distance(
            colors.first[0] - colors.first[1],
            colors.second[0] - colors.second[1],
            colors.third[0] - colors.third[1],
        ).toDouble().pow(COLOR_EXPONENT)
    }

    /** The error at pixel [x], 0..1; 0 where the colours are the same. */
    fun of(
        expected: FilteredRows,
        actual: FilteredRows,
        x: Int,
    ): Float {
        val distance = distance(
            expected.color.first[x] - actual.color.first[x],
            expected.color.second[x] - actual.color.second[x],
            expected.color.third[x] - actual.color.third[x],
        )
        if (distance == 0f) return 0f
        val edge = abs(expected.edge.length(x) - actual.edge.length(x))
        val point = abs(expected.point.length(x) - actual.point.length(x))
        val feature = min(1f, sqrt(SQRT_HALF * max(edge, point)))
        return color(distance).pow(1.0 - feature).toFloat()
    }

    /** HyAB: taxicab in lightness, Euclidean in the other two. */
    private fun distance(
        l: Float,
        a: Float,
        b: Float,
    ): Float = abs(l) + sqrt(a * a + b * b)

    /** A [distance] of colours as an error of 0..1, large ones compressed. */
    private fun color(distance: Float): Double {
        val share = min(1.0, distance.toDouble().pow(COLOR_EXPONENT) / farthest)
        return if (share < KNEE) share * (KNEE_ERROR / KNEE) else KNEE_ERROR + (share - KNEE) / (1 - KNEE) * (1 - KNEE_ERROR)
    }
}

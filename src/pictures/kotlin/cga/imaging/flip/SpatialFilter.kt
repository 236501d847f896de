package cga.imaging.flip

import kotlin.math.PI
import kotlin.math.ceil
import kotlin.math.exp
import kotlin.math.sqrt

/**
 * What the eye still sees of a pattern at a distance: the contrast sensitivity of each opponent colour as a blur (section 4.1 of the
 * 2020 paper). That of [blueYellow] is the sum of two filters.
 */
internal class SpatialFilter(pixelsPerDegree: Double) {
    /** Pixels to each side of the centre: three standard deviations of the widest Gaussian. In float, to round as the reference does. */
    val radius: Int = ceil(3f * sqrt(0.04f / (2f * (PI * PI).toFloat())) * pixelsPerDegree.toFloat()).toInt()

    val luminance: Taps
    val redGreen: Taps
    val blueYellow: List<Taps>

    init {
        // The constants are Table 1 of the paper; width is in degrees².
        val gaussian = { width: Double ->
            DoubleArray(radius + 1) { pixel -> exp(-(PI * pixel / pixelsPerDegree).let { it * it } / width) }
        }
        val scaled = { amplitude: Double, half: DoubleArray -> DoubleArray(half.size) { sqrt(amplitude) * half[it] } }
        luminance = gaussian(0.0047).let { taps(it, sum(it)) }
        redGreen = gaussian(0.0053).let { taps(it, sum(it)) }
        val first = scaled(34.1 * sqrt(PI / 0.04), gaussian(0.04))
        val second = scaled(13.5 * sqrt(PI / 0.025), gaussian(0.025))
        val norm = sqrt(sum(first) * sum(first) + sum(second) * sum(second))
        blueYellow = listOf(taps(first, norm), taps(second, norm))
    }

    private fun sum(half: DoubleArray): Double = 2 * half.sum() - half[0]

    /** [half] / [norm], without the outer weights that rounding to float swallows anyway. */
    private fun taps(
        half: DoubleArray,
        norm: Double,
    ): Taps = Taps(half.map { (it / norm).toFloat() }.dropLastWhile { it < 1e-8f }.toFloatArray())
}

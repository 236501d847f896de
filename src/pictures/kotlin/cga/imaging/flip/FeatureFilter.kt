package cga.imaging.flip

import kotlin.math.ceil
import kotlin.math.exp

/** Finds edges and points in the luminance: a Gaussian with its first and second derivative (section 4.2 of the 2020 paper). */
internal class FeatureFilter(pixelsPerDegree: Double) {
    /** Half of the 0.082° that the paper takes for the width of an edge, in pixels. */
    private val deviation = 0.5f * 0.082f * pixelsPerDegree.toFloat()

    /** Pixels to each side of the centre: three standard deviations. In float, to round as the reference does. */
    val radius: Int = ceil(3f * deviation).toInt()

    /** Its weights sum up to 1. */
    val blur: Taps

    /** The first derivative; the weights of each half sum up to ±1. */
    val slope: Taps

    /** The second derivative; its negative weights sum up to −1, its positive ones to 1. */
    val curvature: Taps

    init {
        val variance = deviation.toDouble() * deviation
        val gaussian = DoubleArray(radius + 1) { exp(-it * it / (2 * variance)) }
        val first = DoubleArray(radius + 1) { it * gaussian[it] }
        val second = DoubleArray(radius + 1) { (it * it / variance - 1) * gaussian[it] }
        val negative = -second[0] - 2 * second.drop(1).filter { it < 0 }.sum()
        val positive = 2 * second.filter { it > 0 }.sum()
        blur = taps(gaussian) { 2 * gaussian.sum() - gaussian[0] }
        slope = Taps(FloatArray(radius + 1) { (first[it] / first.sum()).toFloat() }, odd = true)
        curvature = taps(second) { if (it > 0) positive else negative }
    }

    private fun taps(
        half: DoubleArray,
        norm: (Double) -> Double,
    ): Taps = Taps(FloatArray(half.size) { (half[it] / norm(half[it])).toFloat() })
}

package cga.imaging.report

import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.FloatPicture
import cga.imaging.channels
import cga.imaging.flip.FlipMap
import kotlin.math.abs

// The bars of the error histograms: how many pixels differ by how much.

/** Pixels by their largest channel difference: by powers of two where the pictures hold bytes, of ten where floats. */
internal fun differenceBars(comparison: Comparison): List<Bar> {
    val errors = largestDifferences(comparison)
    return if (comparison.expected is BytePicture) bars(errors, BYTE_LIMITS, BYTE_LABELS) else bars(errors, FLOAT_LIMITS, FLOAT_LABELS)
}

/** Pixels by their ꟻLIP error. */
internal fun flipBars(flip: FlipMap): List<Bar> = bars(flip.error, FLIP_LIMITS, FLIP_LABELS)

private fun largestDifferences(comparison: Comparison): FloatArray {
    val (expected, actual) = comparison.expected to comparison.actual
    val channels = channels(expected)
    val difference: (Int) -> Float =
        when {
            expected is BytePicture && actual is BytePicture -> { i ->
                abs((expected.image.rgba[i].toInt() and 0xFF) - (actual.image.rgba[i].toInt() and 0xFF)).toFloat()
            }
            expected is FloatPicture && actual is FloatPicture -> { i -> abs(expected.image.rgba[i] - actual.image.rgba[i]) }
            else -> error("a comparison of two kinds of picture: $comparison")
        }
    return FloatArray(expected.width * expected.height) { pixel -> (0 until channels).maxOf { difference(4 * pixel + it) } }
}

/** One bar for each of [limits], of the [errors] up to it and above the limit before it; and one for those above the last. */
private fun bars(errors: FloatArray, limits: FloatArray, labels: List<String>): List<Bar> {
    val counts = IntArray(labels.size)
    for (error in errors) counts[limits.indexOfFirst { error <= it }.let { if (it < 0) limits.size else it }]++
    return labels.mapIndexed { i, label -> Bar(label, counts[i]) }
}

private val BYTE_LIMITS = floatArrayOf(0f, 1f, 2f, 4f, 8f, 16f, 32f, 64f, 128f)
private val BYTE_LABELS = listOf("0", "1", "2", "3–4", "5–8", "9–16", "17–32", "33–64", "65–128", "> 128")
private val FLOAT_LIMITS = floatArrayOf(0f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f, 1e-1f, 1f)
private val FLOAT_LABELS = listOf("0", "≤ 1e−6", "1e−5", "1e−4", "1e−3", "0.01", "0.1", "1", "> 1")
private val FLIP_LIMITS = floatArrayOf(0f, 0.01f, 0.02f, 0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.7f)
private val FLIP_LABELS = listOf("0", "≤ 0.01", "0.02", "0.05", "0.1", "0.2", "0.3", "0.5", "0.7", "> 0.7")

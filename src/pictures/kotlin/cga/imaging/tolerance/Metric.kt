package cga.imaging.tolerance

import cga.imaging.Comparison
import cga.imaging.Pixel
import cga.imaging.brief
import cga.imaging.percent
import cga.imaging.step
import cga.imaging.values
import cga.imaging.written

/**
 * One number that a tolerance can bound, computed only when it is asked for.
 *
 * @param title how messages call it.
 * @param higherIsBetter whether a bound is the least allowed value, and not the greatest.
 */
internal abstract class Metric(
    val title: String,
    val higherIsBetter: Boolean = false,
) {
    abstract fun measure(comparison: Comparison): Double

    /** [value] in the unit that people think in. */
    abstract fun format(
        value: Double,
        comparison: Comparison,
    ): String

    /** Where in the picture to look. */
    open fun place(comparison: Comparison): String =
        comparison.difference.worst?.let { "worst at ${describe(it, comparison)}" } ?: "nowhere"
}

/** The largest difference in any channel of any pixel. */
internal object Maximum : Metric("max") {
    override fun measure(comparison: Comparison): Double = comparison.difference.maximum.max()

    override fun format(value: Double, comparison: Comparison) = inPictureUnit(value, comparison)
}

/** The share of pixels that differ at all. */
internal object Differing : Metric("differing pixels") {
    override fun measure(comparison: Comparison): Double = comparison.difference.fraction

    override fun format(value: Double, comparison: Comparison) = percent(value)
}

internal object Rmse : Metric("rmse") {
    override fun measure(comparison: Comparison): Double = comparison.difference.rmse

    override fun format(value: Double, comparison: Comparison) = inPictureUnit(value, comparison)
}

internal object Psnr : Metric("psnr", higherIsBetter = true) {
    override fun measure(comparison: Comparison): Double = comparison.difference.psnr

    override fun format(value: Double, comparison: Comparison) = "${brief(value)} dB"
}

/** The mean difference in the worst window of [size]×[size] pixels. */
internal class WorstWindow(private val size: Int) : Metric("worst ${size}x$size window") {
    override fun measure(comparison: Comparison): Double = comparison.worstWindow(size).error

    override fun format(value: Double, comparison: Comparison) = inPictureUnit(value, comparison)

    override fun place(comparison: Comparison): String = comparison.worstWindow(size).corner.let { "from (${it.x}, ${it.y})" }
}

internal object FlipMean : Metric("ꟻLIP mean") {
    override fun measure(comparison: Comparison): Double = comparison.flip.mean

    override fun format(value: Double, comparison: Comparison) = brief(value)
}

/** The ꟻLIP error that [percent] % of the pixels do not exceed. */
internal class FlipPercentile(private val percent: Double) : Metric("ꟻLIP ${brief(percent)}th percentile") {
    override fun measure(comparison: Comparison): Double = comparison.flip.percentile(percent / 100).toDouble()

    override fun format(value: Double, comparison: Comparison) = brief(value)
}

/** A difference in the unit of the compared pictures. */
private fun inPictureUnit(
    value: Double,
    comparison: Comparison,
): String = step(value, comparison.expected)

private fun describe(
    pixel: Pixel,
    comparison: Comparison,
): String {
    val (expected, actual) = listOf(comparison.expected, comparison.actual).map { written(values(it, pixel)) }
    return "(${pixel.x}, ${pixel.y}), expected $expected, actual $actual"
}

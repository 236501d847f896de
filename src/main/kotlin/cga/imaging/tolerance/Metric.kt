package cga.imaging.tolerance

import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.FloatPicture
import cga.imaging.Picture
import cga.imaging.Pixel
import java.util.Locale

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

    override fun format(value: Double, comparison: Comparison) = "${short(100 * value)} %"
}

internal object Rmse : Metric("rmse") {
    override fun measure(comparison: Comparison): Double = comparison.difference.rmse

    override fun format(value: Double, comparison: Comparison) = inPictureUnit(value, comparison)
}

internal object Psnr : Metric("psnr", higherIsBetter = true) {
    override fun measure(comparison: Comparison): Double = comparison.difference.psnr

    override fun format(value: Double, comparison: Comparison) = "${short(value)} dB"
}

/** The mean difference in the worst window of [size]×[size] pixels. */
internal class WorstWindow(private val size: Int) : Metric("worst ${size}x$size window") {
    override fun measure(comparison: Comparison): Double = comparison.worstWindow(size).error

    override fun format(value: Double, comparison: Comparison) = inPictureUnit(value, comparison)

    override fun place(comparison: Comparison): String = comparison.worstWindow(size).corner.let { "from (${it.x}, ${it.y})" }
}

internal object FlipMean : Metric("ꟻLIP mean") {
    override fun measure(comparison: Comparison): Double = comparison.flip.mean

    override fun format(value: Double, comparison: Comparison) = short(value)
}

/** The ꟻLIP error that [percent] % of the pixels do not exceed. */
internal class FlipPercentile(private val percent: Double) : Metric("ꟻLIP ${short(percent)}th percentile") {
    override fun measure(comparison: Comparison): Double = comparison.flip.percentile(percent / 100).toDouble()

    override fun format(value: Double, comparison: Comparison) = short(value)
}

/** Four digits, without zeros that say nothing. */
internal fun short(value: Double): String {
    if (!value.isFinite()) return "$value"
    val text = String.format(Locale.ROOT, "%.4g", value)
    return if ('e' in text || '.' !in text) text else text.trimEnd('0').trimEnd('.')
}

/** A difference in 1/255 for 8-bit pictures, plainly for float ones. */
internal fun inPictureUnit(
    value: Double,
    comparison: Comparison,
): String =
    when (comparison.expected) {
        is BytePicture -> "${short(value * 255)}/255"
        is FloatPicture -> short(value)
    }

private fun describe(
    pixel: Pixel,
    comparison: Comparison,
) = "(${pixel.x}, ${pixel.y}), expected ${color(comparison.expected, pixel)}, actual ${color(comparison.actual, pixel)}"

private fun color(
    picture: Picture,
    pixel: Pixel,
): String {
    val start = 4 * (pixel.y * picture.width + pixel.x)
    return (start until start + if (picture.hasAlpha) 4 else 3).joinToString(" ") { i ->
        when (picture) {
            is BytePicture -> "${picture.image.rgba[i].toInt() and 0xFF}"
            is FloatPicture -> short(picture.image.rgba[i].toDouble())
        }
    }
}

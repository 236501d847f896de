package cga.imaging.flip

import cga.framework.image.ImageData
import kotlin.math.ceil

/**
 * The ꟻLIP error of every pixel, 0 (equal) to 1, rows from top to bottom.
 *
 * @param exposures the exposures that HDR-ꟻLIP looked at; null for LDR-ꟻLIP.
 */
public class FlipMap(
    public val width: Int,
    public val height: Int,
    public val error: FloatArray,
    public val exposures: Exposures? = null,
) {
    /** Mean over all pixels. */
    public val mean: Double by lazy { error.sumOf { it.toDouble() } / error.size }

    private val sorted: FloatArray by lazy { error.sortedArray() }

    /** The smallest error that the share [fraction] (0..1) of all pixels does not exceed. */
    public fun percentile(fraction: Double): Float {
        require(fraction in 0.0..1.0) { "a share of pixels lies in 0..1, not $fraction" }
        return sorted[(ceil(fraction * sorted.size).toInt() - 1).coerceAtLeast(0)]
    }

    /** The map as the reference implementation draws it: black (equal) over purple and orange to pale yellow. */
    public fun magma(): ImageData {
        val rgba = ByteArray(4 * error.size)
        for ((pixel, value) in error.withIndex()) {
            val color = Magma.color(value)
            rgba[4 * pixel] = (color shr 16).toByte()
            rgba[4 * pixel + 1] = (color shr 8).toByte()
            rgba[4 * pixel + 2] = color.toByte()
            rgba[4 * pixel + 3] = -1
        }
        return ImageData(width, height, rgba)
    }
}

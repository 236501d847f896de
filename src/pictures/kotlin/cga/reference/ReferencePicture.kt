package cga.reference

import cga.framework.image.FloatImage
import cga.framework.image.ImageData

/**
 * What the reference makes of a frame. Rows run from top to bottom.
 *
 * @param rgb three numbers a pixel: linear, unclamped, black where nothing is.
 * @param surface a number a pixel: the triangle it shows, counted through the draws in their order, or [NO_SURFACE]. With several samples
 * a pixel it is that of the sample at the centre (for an even grid: of the one above and to the right of it); likewise [depth].
 * @param depth window depth, 0 at the near plane and 1 at the far plane and where nothing is.
 */
public class ReferencePicture internal constructor(
    public val width: Int,
    public val height: Int,
    public val rgb: DoubleArray = DoubleArray(3 * width * height),
    public val surface: IntArray = IntArray(width * height),
    public val depth: DoubleArray = DoubleArray(width * height),
) {
    /** The picture rounded to floats, opaque. */
    public fun toFloatImage(): FloatImage = FloatImage(width, height, FloatArray(4 * width * height) { channel(it).toFloat() })

    /**
     * The picture as a screen shows it: clamped to 0…1, times 255 (OpenGL 3.3 core, equation 2.4) and rounded to the nearest whole number
     * (which 3.3 leaves open and later versions prefer).
     */
    public fun toImageData(): ImageData =
        ImageData(width, height, ByteArray(4 * width * height) { Math.round(channel(it).coerceIn(0.0, 1.0) * 255).toByte() })

    /** Number [i] of the picture as RGBA. */
    private fun channel(i: Int) = if (i % 4 == 3) 1.0 else rgb[i / 4 * 3 + i % 4]

    public companion object {
        /** Where no triangle is seen. */
        public const val NO_SURFACE: Int = -1
    }
}

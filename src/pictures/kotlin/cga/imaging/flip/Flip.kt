package cga.imaging.flip

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import cga.imaging.requireComparable
import java.util.Arrays

/**
 * NVIDIA's ꟻLIP: how different two pictures look when flipped on a screen.
 *
 * 8-bit pictures are sRGB and give LDR-ꟻLIP (Andersson et al., *FLIP: A Difference Evaluator for Alternating Images*, 2020). Float
 * pictures are linear and give HDR-ꟻLIP: the largest LDR-ꟻLIP over a range of [Exposures] of the expected picture, tone mapped with
 * ACES (Andersson et al., *Visualizing Errors in Rendered High Dynamic Range Images*, 2021). Alpha is not looked at. The result does
 * not depend on the number of threads.
 *
 * Arithmetic is in 32-bit floats, as in the reference implementation (`flip-evaluator` 1.7), but in another order; filter weights are
 * computed and the last two powers taken in double. On the pairs of `tests/flip`, a map differs from the reference's by at most 2.2e-4
 * and the mean of a map by at most 6.5e-6. Pictures of a single colour, where nothing averages rounding out, are the worst: over 400
 * random ones at 4 to 154 pixels per degree the median difference is 2.9e-6 and the largest 7.9e-5, and the reference itself is up to
 * 6e-5 away from a computation in double. There are three differences of meaning:
 * - [FlipMap.mean] is summed up in double. The reference sums in float: off by 3e-5 on a flat map of 64x64, 6e-5 on noise of 1920x1080.
 * - A value that overflows the reference's tone mapper turns black there and white here.
 * - The reference ends the program when no luminance of the expected picture exceeds 2⁻²³ (a black picture, say); see [Exposures].
 */
public object Flip {
    /** Pixels per degree of visual angle at 0.7 m from a 0.7 m wide 4K screen: the reference implementation's default. */
    public const val PIXELS_PER_DEGREE: Double = 67.0206

    private val RESOLUTIONS = 2.0..1000.0

    /**
     * The ꟻLIP map of two pictures on a screen with [pixelsPerDegree] (2..1000) of visual angle. Throws [cga.framework.InputError]
     * where the two cannot be compared.
     */
    public fun compare(
        expected: Picture,
        actual: Picture,
        pixelsPerDegree: Double = PIXELS_PER_DEGREE,
    ): FlipMap {
        require(pixelsPerDegree in RESOLUTIONS) { "pixels per degree must lie in $RESOLUTIONS, not $pixelsPerDegree" }
        requireComparable(expected, actual)
        return when (expected) {
            is BytePicture -> ldr(expected.image, (actual as BytePicture).image, pixelsPerDegree)
            is FloatPicture -> hdr(expected.image, (actual as FloatPicture).image, pixelsPerDegree)
        }
    }

    private fun ldr(
        expected: ImageData,
        actual: ImageData,
        pixelsPerDegree: Double,
    ): FlipMap {
        val row = 4 * expected.width
        val differs = BooleanArray(expected.height) { y ->
            !Arrays.equals(expected.rgba, y * row, (y + 1) * row, actual.rgba, y * row, (y + 1) * row)
        }
        val pair = LinearPair(ByteRows(expected), ByteRows(actual))
        return FlipMap(expected.width, expected.height, LargestError(listOf(pair), differs, pixelsPerDegree).map())
    }

    private fun hdr(
        expected: FloatImage,
        actual: FloatImage,
        pixelsPerDegree: Double,
    ): FlipMap {
        val row = 4 * expected.width
        val differs = BooleanArray(expected.height) { y ->
            !Arrays.equals(expected.rgba, y * row, (y + 1) * row, actual.rgba, y * row, (y + 1) * row)
        }
        val exposures = Exposures.of(expected)
        val pairs = exposures.stops.map { LinearPair(ExposedRows(expected, it), ExposedRows(actual, it)) }
        return FlipMap(expected.width, expected.height, LargestError(pairs, differs, pixelsPerDegree).map(), exposures)
    }
}

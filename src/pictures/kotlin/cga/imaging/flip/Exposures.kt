package cga.imaging.flip

import cga.framework.image.FloatImage
import java.util.Arrays
import kotlin.math.ceil
import kotlin.math.log2
import kotlin.math.max
import kotlin.math.min

/**
 * The exposures at which HDR-ꟻLIP looks at two pictures: [count] of them, in f-stops, evenly from [start] to [stop].
 *
 * At [start] the brightest luminance of the expected picture is mapped to 0.85 of the screen's white, at [stop] its median (section 4.2
 * of the 2021 paper). Both count as 2⁻²³ where they are lower; the reference implementation does the same for the median alone. So a
 * picture that is mostly black is looked at up to f-stop 24, where a light of 10⁻⁷ can be seen.
 */
public class Exposures internal constructor(
    public val start: Float,
    public val stop: Float,
    public val count: Int,
) {
    internal val stops: List<Float> get() = List(count) { start + it * ((stop - start) / (count - 1)) }

    internal companion object {
        /** Those for the picture [expected]. In float and in the reference's order, because [count] jumps at whole f-stops. */
        fun of(expected: FloatImage): Exposures {
            val luminances = luminances(expected)
            Arrays.parallelSort(luminances)
            val brightest = max(luminances.last(), FAINTEST)
            val median = max(luminances[luminances.size / 2], FAINTEST)
            val white = AcesCurve.inverse(0.85f)
            val start = log2(white / brightest)
            val stop = log2(white / median)
            return Exposures(start, stop, max(2, ceil(stop - start).toInt()))
        }

        private const val FAINTEST = 1.1920929e-7f

        /** Of every pixel, by ITU-R BT.709. */
        private fun luminances(image: FloatImage): FloatArray =
            FloatArray(image.width * image.height) {
                val luminance = 0.2126f * image.rgba[4 * it] + 0.7152f * image.rgba[4 * it + 1] + 0.0722f * image.rgba[4 * it + 2]
                min(luminance, Float.MAX_VALUE)
            }
    }
}

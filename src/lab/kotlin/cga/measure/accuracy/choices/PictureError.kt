package cga.measure.accuracy.choices

import kotlin.math.abs

/**
 * How far a picture is from the truth, in units of 1/255 of what a screen shows: of each pixel the channel that is off most, both clamped
 * to 0…1.
 *
 * @param max over the pixels that are compared; likewise [mean].
 */
internal class PictureError(
    val max: Double,
    val mean: Double,
) {
    companion object {
        /** [truth] has three numbers a pixel, [drawn] four. Of the pixels those that [isCompared] count. */
        fun of(
            truth: DoubleArray,
            drawn: FloatArray,
            isCompared: (Int) -> Boolean,
        ): PictureError {
            var count = 0
            var max = 0.0
            var sum = 0.0
            for (pixel in 0 until truth.size / 3) {
                if (!isCompared(pixel)) continue
                val error = 255 * (0..2).maxOf { abs(shown(truth[3 * pixel + it]) - shown(drawn[4 * pixel + it].toDouble())) }
                count++
                sum += error
                max = maxOf(max, error)
            }
            return PictureError(max, if (count == 0) 0.0 else sum / count)
        }

        private fun shown(channel: Double) = channel.coerceIn(0.0, 1.0)
    }
}

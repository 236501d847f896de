package cga.imaging

import kotlin.math.log10
import kotlin.math.sqrt

/** A place in a picture: [x] pixels from the left, [y] from the top. */
public data class Pixel(
    val x: Int,
    val y: Int,
)

/**
 * Two pictures compared number by number. Differences of 8-bit pictures are in units of 1 (a step of one byte is 1/255), those of
 * float pictures in the picture's own unit.
 *
 * @param maximum largest absolute difference of each compared channel: red, green, blue, and alpha where the pictures have it.
 * @param differing number of pixels that differ in any channel.
 * @param pixels number of pixels.
 * @param rmse root of the mean squared difference over pixels and channels.
 * @param worst the pixel with the largest difference in one channel, the first in reading order; null where the pictures are equal.
 */
public class Difference internal constructor(
    public val maximum: DoubleArray,
    public val differing: Int,
    public val pixels: Int,
    public val rmse: Double,
    public val worst: Pixel?,
) {
    /** Share of differing pixels, 0..1. */
    public val fraction: Double get() = differing.toDouble() / pixels

    /** Peak signal-to-noise ratio in dB for a peak of 1: −20·log10(rmse); +∞ for equal pictures. */
    public val psnr: Double get() = -20 * log10(rmse)

    public companion object {
        /** Throws [cga.framework.InputError] where the two cannot be compared: size, kind, channels. */
        public fun between(
            expected: Picture,
            actual: Picture,
        ): Difference {
            val errors = RowErrors.between(expected, actual)
            val sums = Sums(errors)
            if (!errors.areSame) for (y in 0 until errors.height) sums.addRow(y)
            return sums.result()
        }
    }

    /** Sums of 8-bit differences are whole numbers below 2⁵³, so they are exact; of floats they are rounded, row by row. */
    private class Sums(
        private val errors: RowErrors,
    ) {
        private val row = DoubleArray(4 * errors.width)
        private val maximum = DoubleArray(errors.channels)
        private var differing = 0
        private var squares = 0.0
        private var largest = 0.0
        private var worst: Pixel? = null

        fun addRow(y: Int) {
            if (!errors.read(y, row)) return
            var rowSquares = 0.0
            for (x in 0 until errors.width) {
                var pixel = 0.0
                for (c in 0 until errors.channels) {
                    val error = row[4 * x + c]
                    if (error > maximum[c]) maximum[c] = error
                    if (error > pixel) pixel = error
                    rowSquares += error * error
                }
                if (pixel > 0) differing++
                if (pixel > largest) {
                    largest = pixel
                    worst = Pixel(x, y)
                }
            }
            squares += rowSquares
        }

        fun result(): Difference {
            val pixels = errors.width * errors.height
            val rmse = sqrt(squares / (pixels.toDouble() * errors.channels)) / errors.range
            return Difference(DoubleArray(maximum.size) { maximum[it] / errors.range }, differing, pixels, rmse, worst)
        }
    }
}

/**
 * The N×N window in which pictures differ most: a small solid defect that would drown in the whole picture's mean.
 *
 * @param corner its upper left pixel.
 * @param error mean over the window of each pixel's largest channel difference, in [Difference]'s unit.
 */
public class Window internal constructor(
    public val corner: Pixel,
    public val size: Int,
    public val error: Double,
) {
    public companion object {
        /** The worst of all [size]×[size] windows (cut to the picture where that is smaller). */
        public fun worst(
            expected: Picture,
            actual: Picture,
            size: Int,
        ): Window {
            require(size > 0) { "the windows' size is $size, and must be at least 1" }
            val errors = RowErrors.between(expected, actual)
            return if (errors.areSame) Window(Pixel(0, 0), size, 0.0) else Search(errors, size).worst()
        }
    }

    /**
     * Slides a window over the picture: down by sums of the window's part of each column, to the right by a sum of those.
     *
     * The sums are exact for bytes. For floats a value that is added and taken away again leaves a rounding error, of at most 2⁻⁵³ of the
     * largest sum for each step; so the worst window is found up to that, and its error is then summed anew.
     */
    private class Search(
        private val errors: RowErrors,
        private val size: Int,
    ) {
        private val across = minOf(size, errors.width)
        private val down = minOf(size, errors.height)
        private val row = DoubleArray(4 * errors.width)
        private val columns = DoubleArray(errors.width)
        private var largest = 0.0
        private var corner = Pixel(0, 0)

        fun worst(): Window {
            for (y in 0 until errors.height) {
                addRow(y, 1)
                if (y >= down) addRow(y - down, -1)
                if (y >= down - 1) slide(y - down + 1)
            }
            return Window(corner, size, mean() / errors.range)
        }

        private fun addRow(
            y: Int,
            sign: Int,
        ) {
            if (errors.read(y, row)) for (x in columns.indices) columns[x] += sign * pixel(x)
        }

        /** The largest channel of pixel [x] in the row that was read. */
        private fun pixel(x: Int): Double {
            val colour = maxOf(row[4 * x], row[4 * x + 1], row[4 * x + 2])
            return if (errors.channels == 4) maxOf(colour, row[4 * x + 3]) else colour
        }

        private fun slide(top: Int) {
            var sum = 0.0
            for (x in columns.indices) {
                sum += columns[x]
                if (x >= across) sum -= columns[x - across]
                if (x >= across - 1 && sum > largest) {
                    largest = sum
                    corner = Pixel(x - across + 1, top)
                }
            }
        }

        private fun mean(): Double {
            var sum = 0.0
            for (y in corner.y until corner.y + down) {
                if (errors.read(y, row)) for (x in corner.x until corner.x + across) sum += pixel(x)
            }
            return sum / (across.toDouble() * down)
        }
    }
}

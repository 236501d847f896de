package cga.imaging

import java.util.Arrays
import kotlin.math.abs

/**
 * The absolute differences of two pictures, a row at a time, as doubles: exact for bytes; of floats rounded once.
 *
 * Whole runs of equal numbers are found by [Arrays.mismatch], which the JDK compiles to vector instructions. Floats that it calls
 * different may still be equal: 0 and −0 are.
 */
internal sealed class RowErrors(
    val width: Int,
    val height: Int,
    hasAlpha: Boolean,
) {
    /** How many channels count, of the four that are stored. */
    val channels: Int = if (hasAlpha) 4 else 3

    /** What a picture's full range is in these differences. */
    abstract val range: Double

    /** Whether the pictures hold the same bits. */
    abstract val areSame: Boolean

    /** Writes the differences of row [y] to [errors], four a pixel. Returns whether there may be any; where not, nothing is written. */
    abstract fun read(
        y: Int,
        errors: DoubleArray,
    ): Boolean

    private class OfBytes(
        private val expected: BytePicture,
        private val actual: BytePicture,
    ) : RowErrors(expected.width, expected.height, expected.hasAlpha) {
        override val range: Double get() = 255.0
        override val areSame: Boolean get() = expected.image.rgba.contentEquals(actual.image.rgba)

        override fun read(
            y: Int,
            errors: DoubleArray,
        ): Boolean {
            val a = expected.image.rgba
            val b = actual.image.rgba
            val start = 4 * width * y
            if (Arrays.mismatch(a, start, start + 4 * width, b, start, start + 4 * width) < 0) return false
            for (i in 0 until 4 * width) errors[i] = abs((a[start + i].toInt() and 0xFF) - (b[start + i].toInt() and 0xFF)).toDouble()
            return true
        }
    }

    private class OfFloats(
        private val expected: FloatPicture,
        private val actual: FloatPicture,
    ) : RowErrors(expected.width, expected.height, expected.hasAlpha) {
        override val range: Double get() = 1.0
        override val areSame: Boolean get() = expected.image.rgba.contentEquals(actual.image.rgba)

        override fun read(
            y: Int,
            errors: DoubleArray,
        ): Boolean {
            val a = expected.image.rgba
            val b = actual.image.rgba
            val start = 4 * width * y
            if (Arrays.mismatch(a, start, start + 4 * width, b, start, start + 4 * width) < 0) return false
            for (i in 0 until 4 * width) errors[i] = abs(a[start + i].toDouble() - b[start + i].toDouble())
            return true
        }
    }

    companion object {
        /** Throws [cga.framework.InputError] where the two cannot be compared. */
        fun between(
            expected: Picture,
            actual: Picture,
        ): RowErrors {
            requireComparable(expected, actual)
            return when (expected) {
                is BytePicture -> OfBytes(expected, actual as BytePicture)
                is FloatPicture -> OfFloats(expected, actual as FloatPicture)
            }
        }
    }
}

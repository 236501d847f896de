package cga.imaging

import cga.framework.InputError
import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.testing.DOUBLE_ROUNDING
import cga.testing.assertNear
import cga.testing.assertRefused
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import kotlin.math.abs
import kotlin.math.log10
import kotlin.math.sqrt
import kotlin.random.Random

class DifferenceTest {
    private val width = 23
    private val height = 11

    @Test
    fun `equal pictures do not differ`() {
        for (picture in listOf(bytes(1), floats(1))) {
            val difference = Difference.between(picture, picture)
            assertArrayEquals(DoubleArray(4), difference.maximum)
            assertEquals(listOf(0, width * height), listOf(difference.differing, difference.pixels))
            assertEquals(listOf(0.0, 0.0, Double.POSITIVE_INFINITY), listOf(difference.rmse, difference.fraction, difference.psnr))
            assertNull(difference.worst)
            assertEquals(0.0, Window.worst(picture, picture, 4).error)
        }
    }

    @Test
    fun `one byte off by one is found, wherever it is`() {
        val expected = bytes(1)
        for (index in 0 until 4 * width * height) {
            val rgba = expected.image.rgba.copyOf()
            rgba[index] = if (rgba[index] == 0.toByte()) 1 else (rgba[index] - 1).toByte()
            val difference = Difference.between(expected, bytePicture(rgba))
            assertArrayEquals(DoubleArray(4) { if (it == index % 4) 1 / 255.0 else 0.0 }, difference.maximum)
            assertEquals(Pixel(index / 4 % width, index / 4 / width), difference.worst)
            assertEquals(1, difference.differing)
            assertNear(1 / 255.0 / sqrt(4.0 * width * height), difference.rmse, 4 * DOUBLE_ROUNDING)
            assertNear(20 * log10(255 * sqrt(4.0 * width * height)), difference.psnr, 1e-12)
        }
    }

    @Test
    fun `all figures are those of their definitions`() {
        for ((expected, actual) in listOf(bytes(1) to bytes(2), floats(1) to floats(2))) {
            val errors = errors(expected, actual)
            val difference = Difference.between(expected, actual)
            assertArrayEquals(DoubleArray(4) { c -> errors.maxOf { it[c] } }, difference.maximum)
            assertEquals(errors.count { it.max() > 0 }, difference.differing)
            assertEquals(difference.differing.toDouble() / (width * height), difference.fraction)
            val worst = errors.indices.maxBy { errors[it].max() }
            assertEquals(Pixel(worst % width, worst / width), difference.worst)
            // Both sum as many positive numbers, each rounded, in different orders.
            val rmse = sqrt(errors.sumOf { pixel -> pixel.sumOf { it * it } } / (4 * errors.size))
            assertNear(rmse, difference.rmse, rmse * 8 * errors.size * DOUBLE_ROUNDING)
        }
    }

    @Test
    fun `8-bit sums are exact`() {
        val expected = bytePicture(ByteArray(4 * width * height))
        val actual = bytePicture(ByteArray(4 * width * height) { -1 })
        val difference = Difference.between(expected, actual)
        assertEquals(listOf(1.0, 0.0, 1.0), listOf(difference.rmse, abs(difference.psnr), difference.fraction))
    }

    @Test
    fun `alpha counts only where it says something`() {
        val opaque = BytePicture(ImageData(1, 1, byteArrayOf(1, 2, 3, 4)), hasAlpha = false)
        val other = BytePicture(ImageData(1, 1, byteArrayOf(1, 2, 3, 9)), hasAlpha = false)
        assertEquals(3, Difference.between(opaque, other).maximum.size)
        assertEquals(0, Difference.between(opaque, other).differing)
        assertEquals(0.0, Window.worst(opaque, other, 1).error)
        val withAlpha = listOf(opaque, other).map { BytePicture(it.image, hasAlpha = true) }
        assertEquals(1, Difference.between(withAlpha[0], withAlpha[1]).differing)
        assertEquals(5 / 255.0, Window.worst(withAlpha[0], withAlpha[1], 1).error)
    }

    @Test
    fun `zero and minus zero are equal, and the smallest number is not zero`() {
        fun picture(value: Float) = FloatPicture(FloatImage(1, 1, floatArrayOf(value, 0f, 0f, 1f)), hasAlpha = false)
        val difference = Difference.between(picture(0f), picture(-0f))
        assertEquals(0, difference.differing)
        assertNull(difference.worst)
        assertEquals(Float.MIN_VALUE.toDouble(), Difference.between(picture(0f), picture(Float.MIN_VALUE)).maximum[0])
        assertEquals(2.0 * Float.MAX_VALUE, Difference.between(picture(-Float.MAX_VALUE), picture(Float.MAX_VALUE)).maximum[0])
    }

    @Test
    fun `the worst window is the worst of all`() {
        for ((expected, actual) in listOf(bytes(1) to bytes(2), floats(1) to floats(2))) {
            val errors = errors(expected, actual).map { it.max() }
            for (size in listOf(1, 2, 5, 11, 12, 23, 40)) {
                val (across, down) = minOf(size, width) to minOf(size, height)
                val corners = (0..height - down).flatMap { y -> (0..width - across).map { x -> Pixel(x, y) } }

                fun mean(corner: Pixel) = (0 until across * down).sumOf { i ->
                    errors[(corner.y + i / across) * width + corner.x + i % across]
                } / (across * down)
                val worst = corners.maxBy(::mean)
                val window = Window.worst(expected, actual, size)
                assertEquals(worst to size, window.corner to window.size)
                assertNear(mean(worst), window.error, mean(worst) * 2 * across * down * DOUBLE_ROUNDING)
            }
        }
    }

    @Test
    fun `a huge value that has left the window leaves nothing behind`() {
        val rgba = FloatArray(4 * width * height)
        rgba[0] = 1e30f
        val window = Window.worst(floatPicture(FloatArray(rgba.size)), floatPicture(rgba), 3)
        assertEquals(Pixel(0, 0), window.corner)
        assertEquals(1e30f.toDouble() / 9, window.error)
    }

    @Test
    fun `a small solid defect does not drown`() {
        val rgba = ByteArray(4 * 480 * 270)
        val changed = rgba.copyOf()
        for (y in 100 until 116) for (x in 200 until 216) changed[4 * (y * 480 + x)] = 51
        val window = Window.worst(BytePicture(ImageData(480, 270, rgba), true), BytePicture(ImageData(480, 270, changed), true), 16)
        assertEquals(Pixel(200, 100) to 0.2, window.corner to window.error)
    }

    @Test
    fun `a window has a size`() = assertRefused(0) { Window.worst(bytes(1), bytes(1), 0) }

    @Test
    fun `pictures that cannot be compared are refused with both sides`() {
        fun picture(
            width: Int,
            height: Int,
            alpha: Boolean,
        ) = BytePicture(ImageData(width, height, ByteArray(4 * width * height)), alpha)
        assertNotComparable(picture(2, 3, true), picture(3, 2, true), "size", "2x3", "3x2")
        assertNotComparable(picture(2, 3, true), picture(2, 3, false), "channels: alpha is expected, and no alpha")
        val float = FloatPicture(FloatImage(2, 3, FloatArray(24)), true)
        assertNotComparable(picture(2, 3, true), float, "kind: 8 bits a channel is expected, and float")
    }

    @Test
    fun `a float picture with values that are not finite is refused`() {
        val rgba = FloatArray(4 * 3 * 2)
        rgba[4 * 5 + 2] = Float.NaN
        val message = assertThrows<InputError> { FloatPicture(FloatImage(3, 2, rgba), true) }.message.orEmpty()
        assertTrue("1 value is not finite: NaN in blue at x = 2, y = 1" in message, message)
        rgba[4] = Float.NEGATIVE_INFINITY
        val two = assertThrows<InputError> { FloatPicture.opaque(FloatImage(3, 2, rgba)) }.message.orEmpty()
        assertTrue("2 values are not finite, the first: -Infinity in red at x = 1, y = 0" in two, two)
    }

    @Test
    fun `an alpha that means nothing may be anything`() {
        val image = FloatImage(1, 1, floatArrayOf(1f, 2f, 3f, Float.NaN))
        assertEquals(listOf(1f, 2f, 3f, 1f), FloatPicture.opaque(image).image.rgba.toList())
    }

    private fun assertNotComparable(
        expected: Picture,
        actual: Picture,
        vararg parts: String,
    ) {
        for (compare in listOf({ Difference.between(expected, actual) }, { Window.worst(expected, actual, 2) })) {
            val message = assertThrows<InputError> { compare() }.message.orEmpty()
            for (part in parts) assertTrue(part in message) { "the message does not say \"$part\": $message" }
        }
    }

    /** The differences of each pixel's channels, in parts of the full range, by definition. */
    private fun errors(
        expected: Picture,
        actual: Picture,
    ): List<DoubleArray> {
        fun Picture.value(
            i: Int,
        ) = if (this is BytePicture) (image.rgba[i].toInt() and 0xFF).toDouble() else (this as FloatPicture).image.rgba[i].toDouble()
        val range = if (expected is BytePicture) 255 else 1
        return List(width * height) { pixel ->
            DoubleArray(4) { c ->
                abs(expected.value(4 * pixel + c) - actual.value(4 * pixel + c)) /
                    range
            }
        }
    }

    private fun bytes(seed: Int) = bytePicture(Random(seed).nextBytes(4 * width * height))

    private fun floats(seed: Int): FloatPicture {
        val random = Random(seed)
        return floatPicture(FloatArray(4 * width * height) { random.nextFloat() * 100 - 50 })
    }

    private fun bytePicture(rgba: ByteArray) = BytePicture(ImageData(width, height, rgba), hasAlpha = true)

    private fun floatPicture(rgba: FloatArray) = FloatPicture(FloatImage(width, height, rgba), hasAlpha = true)
}

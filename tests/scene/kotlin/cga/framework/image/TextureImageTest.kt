package cga.framework.image

import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.sqrt
import kotlin.random.Random

class TextureImageTest {
    @Test
    fun `row 0 is the picture's lowest`() {
        assertEquals(listOf(listOf(3, 4, 1, 2)), levels(2, 2, listOf(1, 2, 3, 4), mipmaps = false))
    }

    @Test
    fun `each level is the mean of the picture's texels, rounded once`() {
        val picture =
            listOf(
                0, 0, 255, 255,
                0, 1, 255, 254,
                9, 9, 100, 102,
                9, 11, 101, 103,
            )
        // From below: (9+11+9+9)/4 = 9.5, (101+103+100+102)/4 = 101.5, (0+1+0+0)/4 = 0.25, (255+254+255+255)/4 = 254.75;
        // all sixteen add up to 1464, whose mean is 91.5. What lies in the middle goes to the even number.
        val expected = listOf(listOf(9, 11, 101, 103, 9, 9, 100, 102, 0, 1, 255, 254, 0, 0, 255, 255), listOf(10, 102, 0, 255), listOf(92))
        assertEquals(expected, levels(4, 4, picture))
    }

    @Test
    fun `a side that has come to 1 stays there`() {
        assertEquals(listOf(listOf(1, 2, 3, 4), listOf(2, 4), listOf(2)), levels(4, 1, listOf(1, 2, 3, 4)))
        assertEquals(listOf(listOf(4, 3, 2, 1), listOf(4, 2), listOf(2)), levels(1, 4, listOf(1, 2, 3, 4)))
        assertEquals(listOf(listOf(7)), levels(1, 1, listOf(7)))
    }

    @Test
    fun `no level is brighter or darker than the picture`() {
        val random = Random(30)
        val reds = List(512 * 512) { random.nextInt(256) }
        val levels = levels(512, 512, reds)
        for (level in levels.filter { it.size >= 64 }) {
            // A rounded mean is off by up to 1/2, evenly spread: standard deviation 1/√12 a texel, ten of it for the mean of all.
            val bound = 10 / sqrt(12.0 * level.size)
            assertEquals(reds.average(), level.average(), bound, "${level.size} texels")
        }
    }

    @Test
    fun `a colour is kept as it is`() {
        val color = Vector3f(0.1f, 1.7f, 0f)
        assertEquals(color, TextureImage.ofColor(color).color)
    }

    @Test
    fun `an odd last column and row are left out`() {
        // Rows from below: 7 8 9, 4 5 6, 1 2 3.
        assertEquals(listOf(listOf(7, 8, 9, 4, 5, 6, 1, 2, 3), listOf(6)), levels(3, 3, (1..9).toList()))
    }

    @Test
    fun `the sizes are OpenGL's`() {
        val image = TextureImage(ImageData(20, 5, ByteArray(400)), true)
        assertEquals(listOf(20 to 5, 10 to 2, 5 to 1, 2 to 1, 1 to 1), image.levels.map { it.width to it.height })
    }

    /** The levels of a picture of the given reds, as reds; the other channels must follow in their own way. */
    private fun levels(
        width: Int,
        height: Int,
        reds: List<Int>,
        mipmaps: Boolean = true,
    ): List<List<Int>> {
        val rgba = reds.flatMap { listOf(it, 255 - it, 40, 255) }.map { it.toByte() }.toByteArray()
        val levels = TextureImage(ImageData(width, height, rgba), mipmaps).levels
        for (level in levels) {
            assertEquals(
                setOf(40 to 255),
                level.rgba.toList().chunked(4).map { (it[2].toInt() and 0xFF) to (it[3].toInt() and 0xFF) }.toSet(),
            )
        }
        return levels.map { level -> level.rgba.toList().chunked(4).map { it[0].toInt() and 0xFF } }
    }
}

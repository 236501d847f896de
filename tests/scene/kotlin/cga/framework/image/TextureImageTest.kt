package cga.framework.image

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class TextureImageTest {
    @Test
    fun `row 0 is the picture's lowest`() {
        assertEquals(listOf(listOf(3, 4, 1, 2)), levels(2, 2, listOf(1, 2, 3, 4), mipmaps = false))
    }

    @Test
    fun `each level is the mean of four texels of the one above, rounded half up`() {
        val picture =
            listOf(
                0, 0, 255, 255,
                0, 1, 255, 254,
                9, 9, 100, 102,
                9, 11, 101, 103,
            )
        // From below: (9+11+9+9)/4 = 9.5, (101+103+100+102)/4 = 101.5, (0+1+0+0)/4 = 0.25, (255+254+255+255)/4 = 254.75;
        // and of these (10+102+0+255)/4 = 91.75.
        val expected = listOf(listOf(9, 11, 101, 103, 9, 9, 100, 102, 0, 1, 255, 254, 0, 0, 255, 255), listOf(10, 102, 0, 255), listOf(92))
        assertEquals(expected, levels(4, 4, picture))
    }

    @Test
    fun `a side that has come to 1 stays there`() {
        assertEquals(listOf(listOf(1, 2, 3, 4), listOf(2, 4), listOf(3)), levels(4, 1, listOf(1, 2, 3, 4)))
        assertEquals(listOf(listOf(4, 3, 2, 1), listOf(4, 2), listOf(3)), levels(1, 4, listOf(1, 2, 3, 4)))
        assertEquals(listOf(listOf(7)), levels(1, 1, listOf(7)))
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

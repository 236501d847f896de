package cga.imaging.report

import cga.framework.image.ImageData
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayInputStream
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.random.Random

class SmallPngTest {
    @TempDir
    lateinit var folder: Path

    private val random = Random(1)
    private val pictures =
        mapOf(
            "one pixel" to picture(1, 1) { _, _, channel -> 50 * channel },
            "one column" to picture(1, 300) { _, y, channel -> y + channel },
            "one row" to picture(300, 1) { x, _, channel -> x * (channel + 1) },
            "256 colours" to picture(16, 16) { x, y, channel -> if (channel == 1) 16 * y + x else 7 },
            "257 colours" to picture(257, 1) { x, _, channel -> if (channel == 1) x % 256 else x / 256 },
            "noise" to picture(37, 23) { _, _, _ -> random.nextInt(256) },
            "gradient" to gradient(64, 36),
        )

    @Test
    fun `what is written is read back, by stb_image and by ImageIO`() {
        for ((name, picture) in pictures) {
            val png = SmallPng.encode(picture.image)
            val file = folder.resolve("picture.png")
            Files.write(file, png)
            assertArrayEquals(picture.image.rgba, ImageData.read("$file").rgba, name)
            val read = ImageIO.read(ByteArrayInputStream(png))
            assertEquals(picture.width to picture.height, read.width to read.height, name)
            for (pixel in 0 until picture.width * picture.height) {
                val (x, y) = pixel % picture.width to pixel / picture.width
                val color = (0..2).fold(0) { sum, i -> (sum shl 8) or (picture.image.rgba[4 * pixel + i].toInt() and 0xFF) }
                assertEquals(color, read.getRGB(x, y) and 0xFFFFFF, "$name at $x, $y")
            }
        }
    }

    @Test
    fun `few colours get a palette, from dark to bright`() {
        assertEquals(3, colorType(pictures.getValue("256 colours").image))
        assertEquals(2, colorType(pictures.getValue("257 colours").image))
        val png = SmallPng.encode(pictures.getValue("256 colours").image)
        // Signature 8, header 25, then length and name of the palette; only green differs.
        val greens = List(256) { png[8 + 25 + 8 + 3 * it + 1].toInt() and 0xFF }
        assertEquals(greens.sorted(), greens)
    }

    private fun colorType(image: ImageData) = SmallPng.encode(image)[8 + 8 + 9].toInt()
}

package cga.framework.image

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.listDirectoryEntries
import kotlin.random.Random

class PngFileTest {
    @Test
    fun `what is written is read again, by stb and by the JDK`(
        @TempDir folder: Path,
    ) {
        val file = folder.resolve("picture.png")
        val image = ImageData(37, 11, Random(1).nextBytes(4 * 37 * 11))
        PngFile.write(image, file)
        assertEquals(listOf(file), folder.listDirectoryEntries())
        val opaque = image.rgba.mapIndexed { i, byte -> if (i % 4 == 3) -1 else byte }.toByteArray()
        assertArrayEquals(opaque, ImageData.read("$file").rgba)
        val jdk = ImageIO.read(file.toFile())
        assertEquals(37 to 11, jdk.width to jdk.height)
        assertEquals(3, jdk.colorModel.numComponents)
        val (r, g, b) = List(3) { opaque[4 * (2 * 37 + 5) + it].toInt() and 0xFF }
        assertEquals(0xFF shl 24 or (r shl 16) or (g shl 8) or b, jdk.getRGB(5, 2))
    }

    @Test
    fun `pictures of any number of strips are whole`(
        @TempDir folder: Path,
    ) {
        val file = folder.resolve("picture.png")
        // One row, a strip, a row more, several strips; more than one batch; nothing that can be packed, and nothing but one colour.
        val sizes = listOf(1 to 1, 5 to PngStrip.ROWS, 5 to PngStrip.ROWS + 1, 300 to 5 * PngStrip.ROWS - 1, 3 to 40 * PngStrip.ROWS)
        for ((width, height) in sizes) {
            for (rgba in listOf(Random(2).nextBytes(4 * width * height), ByteArray(4 * width * height) { -1 })) {
                PngFile.write(ImageData(width, height, rgba), file)
                val opaque = rgba.mapIndexed { i, byte -> if (i % 4 == 3) -1 else byte }.toByteArray()
                val read = ImageData.read("$file")
                assertEquals(width to height, read.width to read.height)
                assertArrayEquals(opaque, read.rgba)
                assertNotNull(ImageIO.read(file.toFile()))
            }
        }
    }
}

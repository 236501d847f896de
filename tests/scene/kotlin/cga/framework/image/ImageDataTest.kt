package cga.framework.image

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.createDirectory
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes

class ImageDataTest {
    @TempDir
    private lateinit var folder: Path
    private val file get() = folder.resolve("picture.png")

    @Test
    fun `a picture is read with its colours in their places, the top row first`() {
        val image = BufferedImage(3, 2, BufferedImage.TYPE_INT_ARGB)
        val colors = listOf(0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0x80102030, 0xFFFFFFFF, 0xFF000000)
        colors.forEachIndexed { i, argb -> image.setRGB(i % 3, i / 3, argb.toInt()) }
        ImageIO.write(image, "png", file.toFile())
        val read = ImageData.read("$file")
        assertEquals(3 to 2, read.width to read.height)
        assertEquals(colors, List(6) { i -> argb(read, i) })
    }

    @Test
    fun `grey and opaque pictures become RGBA`() {
        val grey = BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY)
        grey.raster.setSample(0, 0, 0, 77)
        ImageIO.write(grey, "png", file.toFile())
        assertEquals(0xFF4D4D4D, argb(ImageData.read("$file"), 0))
    }

    @Test
    fun `a picture of 16 bits a channel is refused, and not cut to 8`() {
        ImageIO.write(BufferedImage(2, 2, BufferedImage.TYPE_USHORT_GRAY), "png", file.toFile())
        val message = assertThrows<InputError> { ImageData.read("$file") }.message.orEmpty()
        assertTrue("$file has 16 bits a channel" in message && "save it with 8 bits" in message, message)
    }

    @Test
    fun `a colour is clamped and rounded`() {
        assertArrayEquals(byteArrayOf(0, -128, -1, -1), ImageData.ofColor(-1f, 0.5f, 7f).rgba)
        assertArrayEquals(byteArrayOf(1, 2, -2, -1), ImageData.ofColor(0.9f / 255, 2.4f / 255, 253.6f / 255).rgba)
    }

    @Test
    fun `bytes that do not fit the size are refused`() {
        for ((width, height, size) in listOf(Triple(1, 1, 3), Triple(2, 2, 4), Triple(0, 1, 0), Triple(-1, -1, 4))) {
            val message = assertThrows<IllegalArgumentException> { ImageData(width, height, ByteArray(size)) }.message.orEmpty()
            assertTrue("${width}x$height" in message && "$size" in message, message)
        }
    }

    @Test
    fun `what is no picture is named, with the cure`() {
        ImageIO.write(BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB), "png", file.toFile())
        val png = file.readBytes()
        val broken =
            mapOf(
                "empty" to ByteArray(0),
                "half" to png.copyOf(png.size / 2),
                "signature alone" to png.copyOf(8),
                "text" to "not a picture".toByteArray(),
                "other compression" to png.copyOf().also { it[26] = 9 },
                "garbage data" to png.copyOf().also { it.fill(0x55, 41, png.size - 16) },
            )
        for ((what, bytes) in broken) {
            file.writeBytes(bytes)
            assertRefused(file, "save it again as PNG", what)
        }
    }

    @Test
    fun `missing files and folders are named, with the cure`() {
        assertRefused(folder.resolve("missing.png"), "does not exist", "missing")
        assertRefused(folder.resolve("folder.png").createDirectory(), "is a folder", "folder")
    }

    private fun assertRefused(
        path: Path,
        cure: String,
        what: String,
    ) {
        val message = assertThrows<InputError>(what) { ImageData.read("$path") }.message.orEmpty()
        assertTrue("texture file $path" in message && cure in message, "$what: $message")
    }

    private fun argb(
        image: ImageData,
        pixel: Int,
    ): Long {
        val (r, g, b, a) = List(4) { image.rgba[4 * pixel + it].toLong() and 0xFF }
        return (a shl 24) or (r shl 16) or (g shl 8) or b
    }
}

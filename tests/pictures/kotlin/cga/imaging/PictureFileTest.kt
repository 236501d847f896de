package cga.imaging

import cga.framework.InputError
import cga.framework.image.ExrFile
import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.framework.image.PngFile
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeBytes
import kotlin.random.Random

class PictureFileTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `what the program writes it reads again, whatever the file is called`() {
        val rgba = Random(1).nextBytes(4 * 37 * 11)
        for (i in 3 until rgba.size step 4) rgba[i] = -1
        val png = folder.resolve("picture.exr")
        PngFile.write(ImageData(37, 11, rgba), png)
        val bytes = PictureFile.read(png) as BytePicture
        assertEquals(37 to 11, bytes.width to bytes.height)
        assertArrayEquals(rgba, bytes.image.rgba)
        assertFalse(bytes.hasAlpha)

        val exr = folder.resolve("picture.png")
        ExrFile.write(FloatImage(1, 2, FloatArray(8) { it / 3f }), exr)
        val floats = PictureFile.read(exr) as FloatPicture
        assertArrayEquals(FloatArray(8) { it / 3f }, floats.image.rgba)
        assertTrue(floats.hasAlpha)
    }

    @Test
    fun `a file that is not there, a folder, a device`() {
        val missing = folder.resolve("missing.png")
        assertRefused(missing, "does not exist")
        assertRefused(folder, "is a folder")
        val device = Path.of("/dev/zero")
        assumeTrue(device.exists())
        assertRefused(device, "is not a plain file")
    }

    @Test
    fun `a file that cannot be read`() {
        // Linux answers an input/output error for the first page of a process's memory, to root too.
        val unreadable = Path.of("/proc/self/mem")
        assumeTrue(unreadable.exists())
        assertRefused(unreadable, "cannot be read", "check its permissions")
    }

    @Test
    fun `a file larger than any picture is not read at all`() {
        val file = folder.resolve("large.png")
        // With a hole: it takes no room on the disk.
        RandomAccessFile(file.toFile(), "rw").use { it.setLength(641L shl 20) }
        assertRefused(file, "larger than 640 MiB", "make the picture smaller")
    }

    @Test
    fun `an empty file and the beginning of one`() {
        assertContentRefused("", "it is empty")
        assertContentRefused("\u0089PNG\r\n", "cut off after 6 bytes")
        assertContentRefused("\u0076", "cut off after 1 bytes")
    }

    @Test
    fun `another kind of picture is called by its name`() {
        assertContentRefused("\u00FF\u00D8\u00FF\u00E0 JFIF", "it is a JPEG: save it as PNG")
        assertContentRefused("GIF89a", "it is a GIF: save it as PNG")
        assertContentRefused("BM123456", "it is a BMP")
        assertContentRefused("RIFF1234WEBPVP8 ", "it is a WebP")
        assertContentRefused("II*\u00001234", "it is a TIFF")
        assertContentRefused("#?RADIANCE\n", "it is a Radiance HDR", "OpenEXR for floats")
        assertContentRefused("P6\n1 1\n255\nabc", "it is a PNM")
        assertContentRefused("\u0089PNG\n\u001A\n", "changed on its way, as by a transfer as text")
        assertContentRefused("\u001B[31mred", "it is neither PNG nor OpenEXR")
        for (letter in 0..255) assertContentRefused(letter.toChar().toString().repeat(40), "it is ")
    }

    private fun assertContentRefused(
        content: String,
        vararg parts: String,
    ) {
        val file = folder.resolve("picture.png")
        file.writeBytes(content.toByteArray(Charsets.ISO_8859_1))
        assertRefused(file, *parts)
        Files.delete(file)
    }

    private fun assertRefused(
        file: Path,
        vararg parts: String,
    ) {
        val message = assertThrows<InputError> { PictureFile.read(file) }.message.orEmpty()
        for (part in listOf("picture file $file", *parts)) assertTrue(part in message) { "the message does not say \"$part\": $message" }
        assertTrue(message.endsWith(".") && message.lines().size == 1) { message }
    }
}

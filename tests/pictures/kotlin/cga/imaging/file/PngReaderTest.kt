package cga.imaging.file

import cga.framework.InputError
import cga.imaging.BytePicture
import cga.imaging.PictureFile
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.assertThrows
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import javax.imageio.IIOImage
import javax.imageio.ImageIO
import javax.imageio.ImageTypeSpecifier
import javax.imageio.ImageWriteParam
import javax.imageio.metadata.IIOMetadataNode
import javax.imageio.stream.MemoryCacheImageOutputStream
import kotlin.random.Random

class PngReaderTest {
    /** The JDK writes with all filters and reads again: its reader is the oracle for sound files. */
    @TestFactory
    fun `what the JDK writes is read as the JDK reads it`(): List<DynamicTest> {
        val types =
            mapOf(
                "RGB" to BufferedImage.TYPE_3BYTE_BGR,
                "RGBA" to BufferedImage.TYPE_4BYTE_ABGR,
                "grey" to BufferedImage.TYPE_BYTE_GRAY,
                "one bit" to BufferedImage.TYPE_BYTE_BINARY,
                "palette" to BufferedImage.TYPE_BYTE_INDEXED,
            )
        return types.flatMap { (name, type) ->
            listOf(false, true).flatMap { interlaced ->
                listOf(1 to 1, 3 to 2, 5 to 9, 37 to 19).map { (width, height) ->
                    dynamicTest("$name ${width}x$height${if (interlaced) " interlaced" else ""}") {
                        val file = written(noise(width, height, type), interlaced)
                        assertSame(ImageIO.read(ByteArrayInputStream(file)), PngReader.read(file))
                    }
                }
            }
        }
    }

    @Test
    fun `alpha is what the file tells`() {
        val pixel = bytes(0, 1, 2, 3, 4)
        assertPixels(true, listOf(1, 2, 3, 4), PngBytes.picture(PngBytes.header(1, 1, 6), pixel))
        assertPixels(true, listOf(1, 1, 1, 2), PngBytes.picture(PngBytes.header(1, 1, 4), pixel.copyOf(3)))
        assertPixels(false, listOf(1, 2, 3, 255), PngBytes.picture(PngBytes.header(1, 1, 2), pixel.copyOf(4)))
        assertPixels(false, listOf(1, 1, 1, 255), PngBytes.picture(PngBytes.header(1, 1, 0), pixel.copyOf(2)))
    }

    @Test
    fun `one colour can be transparent`() {
        val rgb = PngBytes.picture(PngBytes.header(2, 1), bytes(0, 9, 8, 7, 9, 8, 6), PngBytes.chunk("tRNS", bytes(0, 9, 0, 8, 0, 7)))
        assertPixels(true, listOf(9, 8, 7, 0, 9, 8, 6, 255), rgb)
        val grey = PngBytes.picture(PngBytes.header(2, 1, 0, 4), bytes(0, 0x3A), PngBytes.chunk("tRNS", bytes(0, 10)))
        assertPixels(true, listOf(51, 51, 51, 255, 170, 170, 170, 0), grey)
    }

    @Test
    fun `a palette may have transparencies for its first colours`() {
        val palette = PngBytes.chunk("PLTE", bytes(1, 2, 3, 4, 5, 6))
        val file = PngBytes.picture(PngBytes.header(3, 1, 3, 1), bytes(0, 0b01000000), palette, PngBytes.chunk("tRNS", bytes(77)))
        assertPixels(true, listOf(1, 2, 3, 77, 4, 5, 6, 255, 1, 2, 3, 77), file)
    }

    @Test
    fun `how a picture should be shown changes no value`() {
        val rows = bytes(0, 10, 100, 200)
        val gamma = PngBytes.chunk("gAMA", bytes(0, 0, 1, 0))
        val profile = PngBytes.chunk("iCCP", "profile".toByteArray() + bytes(0, 0) + deflated(ByteArray(100)))
        val text = PngBytes.chunk("tEXt", "Comment".toByteArray() + 0 + "any".toByteArray())
        val file = PngBytes.picture(PngBytes.header(1, 1), rows, gamma, profile, PngBytes.chunk("sRGB", bytes(0)), text)
        assertPixels(false, listOf(10, 100, 200, 255), file)
    }

    @Test
    fun `pixels may come in many pieces, empty ones too`() {
        val stream = deflated(bytes(0, 10, 100, 200))
        val pieces = stream.flatMap { listOf(PngBytes.chunk("IDAT", byteArrayOf(it)), PngBytes.chunk("IDAT")) }
        assertPixels(false, listOf(10, 100, 200, 255), PngBytes.of(PngBytes.header(1, 1), *pieces.toTypedArray(), PngBytes.END))
    }

    @TestFactory
    fun `a file that is not whole is refused with its reason`(): List<DynamicTest> = refused(damaged())

    @TestFactory
    fun `a file of a kind that cannot be compared is refused with its reason`(): List<DynamicTest> = refused(unsuitable())

    @Test
    fun `no file cut off anywhere is taken for a picture`() {
        for (interlaced in listOf(false, true)) {
            val file = written(noise(9, 7, BufferedImage.TYPE_4BYTE_ABGR), interlaced)
            for (length in 0 until file.size) assertRefused(file.copyOf(length), "it is ", "save it again.")
        }
    }

    @Test
    fun `no change of a byte goes unseen`() {
        val file = written(noise(9, 7, BufferedImage.TYPE_3BYTE_BGR), true)
        for (i in file.indices) {
            val changed = file.copyOf()
            changed[i] = (changed[i] + 1).toByte()
            assertRefused(changed)
        }
    }

    private fun refused(files: List<Refused>): List<DynamicTest> = files.map { dynamicTest(it.what) { assertRefused(it.file, *it.parts) } }

    private class Refused(
        val what: String,
        val file: ByteArray,
        vararg val parts: String,
    )

    private fun damaged(): List<Refused> {
        val header = PngBytes.header(2, 2)
        val rows = bytes(0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6)
        val pixels = PngBytes.chunk("IDAT", deflated(rows))
        val sound = PngBytes.of(header, pixels, PngBytes.END)
        val palette = PngBytes.chunk("PLTE", bytes(1, 2, 3))
        val wrongSum = deflated(rows).also { it[it.size - 1]++ }
        val dictionary = bytes(0x78, 0xBB, 0, 0, 0, 1, 3, 0)
        return listOf(
            Refused("no end", PngBytes.of(header, pixels), "cut off after ${sound.size - 12} bytes", "save it again"),
            Refused("half", sound.copyOf(sound.size / 2), "cut off after ${sound.size / 2} bytes", "save it again"),
            Refused("only the signature", PngChunks.SIGNATURE, "cut off after 8 bytes", "save it again"),
            Refused("bytes after the end", sound + 1 + 2, "2 bytes follow its end"),
            Refused("no header", PngBytes.of(pixels, PngBytes.END), "first chunk is IDAT, not IHDR"),
            Refused("a short header", PngBytes.of(PngBytes.chunk("IHDR", ByteArray(12)), PngBytes.END), "header has 12 bytes, not 13"),
            Refused("no pixels", PngBytes.of(header, PngBytes.END), "no pixels"),
            Refused("a wrong checksum", sound.copyOf().also { it[20]++ }, "checksum of the chunk at byte 8 is wrong"),
            Refused("a negative length", sound.copyOf().also { it[8] = -1 }, "length of a chunk at byte 8 is negative"),
            Refused("pixels torn apart", PngBytes.of(header, pixels, PngBytes.chunk("tEXt"), pixels, PngBytes.END), "torn apart"),
            Refused("an unknown chunk that is needed", PngBytes.picture(header, rows, PngBytes.chunk("ABCD")), "chunk ABCD is not known"),
            Refused(
                "a chunk without a name",
                PngBytes.picture(header, rows, PngBytes.chunk("A\u001B[m")),
                "of an unknown kind is not known",
            ),
            Refused("two headers", PngBytes.picture(header, rows, header), "chunk IHDR is not known"),
            Refused("two palettes", PngBytes.picture(header, rows, palette, palette), "chunk PLTE twice"),
            Refused("a palette at the end", PngBytes.of(header, pixels, palette, PngBytes.END), "chunk PLTE comes after the pixels"),
            Refused("an end with content", PngBytes.of(header, pixels, PngBytes.chunk("IEND", bytes(0))), "IEND is not empty"),
            Refused("too few rows", PngBytes.picture(PngBytes.header(2, 3), rows), "data end too early"),
            Refused("too many rows", PngBytes.picture(PngBytes.header(2, 1), rows), "more data than its size needs"),
            Refused("more after the pixels", PngBytes.of(header, pixels, PngBytes.chunk("IDAT", bytes(0)), PngBytes.END), "more data than"),
            Refused("zlib's checksum", PngBytes.of(header, PngBytes.chunk("IDAT", wrongSum), PngBytes.END), "data are damaged"),
            Refused("not zlib", PngBytes.of(header, PngBytes.chunk("IDAT", bytes(1, 2, 3)), PngBytes.END), "data are damaged"),
            Refused("a dictionary", PngBytes.of(header, PngBytes.chunk("IDAT", dictionary), PngBytes.END), "a dictionary is asked for"),
            Refused("an unknown filter", PngBytes.picture(header, rows.copyOf().also { it[7] = 5 }), "unknown filter 5"),
            Refused("no palette", PngBytes.picture(PngBytes.header(1, 1, 3), bytes(0, 0)), "no palette"),
            Refused(
                "a torn palette",
                PngBytes.picture(PngBytes.header(1, 1, 3), bytes(0, 0), PngBytes.chunk("PLTE", bytes(1, 2))),
                "palette of 2",
            ),
            Refused("an index outside", PngBytes.picture(PngBytes.header(1, 1, 3), bytes(0, 1), palette), "1 colours", "number 1"),
        )
    }

    private fun unsuitable(): List<Refused> {
        val rows = bytes(0, 1, 2, 3)
        val tooMany = PngBytes.chunk("tRNS", bytes(1, 2))
        return listOf(
            Refused("16 bits", PngBytes.picture(PngBytes.header(1, 1, 2, 16), ByteArray(7)), "16 bits a channel", "save it with 8"),
            Refused("16 bits of grey", PngBytes.picture(PngBytes.header(1, 1, 0, 16), ByteArray(3)), "16 bits a channel", "save it with 8"),
            Refused(
                "animated",
                PngBytes.picture(PngBytes.header(1, 1), rows, PngBytes.chunk("acTL", ByteArray(8))),
                "animated",
                "save one picture",
            ),
            Refused(
                "gigantic",
                PngBytes.picture(PngBytes.header(100_000, 100_000), rows),
                "100000x100000",
                "$MAX_PIXELS pixels",
                "smaller",
            ),
            Refused("more than an Int holds", PngBytes.picture(PngBytes.header(-1, -1), rows), "4294967295x4294967295", "smaller"),
            Refused("just too large", PngBytes.picture(PngBytes.header(8192, 4097), rows), "8192x4097", "smaller"),
            Refused("large and empty", PngBytes.picture(PngBytes.header(8192, 4096), rows), "bytes of data are too few for its size"),
            Refused("no width", PngBytes.picture(PngBytes.header(0, 1), rows), "size is 0x1"),
            Refused("a colour type that is none", PngBytes.picture(PngBytes.header(1, 1, 5), rows), "colour type 5, 8 bits"),
            Refused("a depth that is none", PngBytes.picture(PngBytes.header(1, 1, 2, 4), rows), "colour type 2, 4 bits"),
            Refused("an unknown compression", PngBytes.picture(PngBytes.header(1, 1, compression = 1), rows), "compression 1"),
            Refused("an unknown interlace", PngBytes.picture(PngBytes.header(1, 1, interlace = 2), rows), "interlace 2"),
            Refused("alpha twice", PngBytes.picture(PngBytes.header(1, 1, 6), bytes(0, 1, 2, 3, 4), tooMany), "alpha twice"),
            Refused("a torn transparent colour", PngBytes.picture(PngBytes.header(1, 1), rows, tooMany), "transparent colour has 2 bytes"),
        )
    }

    private fun assertRefused(
        file: ByteArray,
        vararg parts: String,
    ) {
        val message = assertThrows<InputError> { PictureFile.decode(file) }.message.orEmpty()
        for (part in parts) assertTrue(part in message) { "the message does not say \"$part\": $message" }
        assertTrue(message.endsWith(".") && message.lines().size == 1) { message }
    }

    private fun assertPixels(
        hasAlpha: Boolean,
        expected: List<Int>,
        file: ByteArray,
    ) {
        val picture = PictureFile.decode(file) as BytePicture
        assertEquals(expected, picture.image.rgba.map { it.toInt() and 0xFF })
        assertEquals(hasAlpha, picture.hasAlpha)
    }

    private fun assertSame(
        expected: BufferedImage,
        actual: BytePicture,
    ) {
        assertEquals(expected.width to expected.height, actual.width to actual.height)
        assertEquals(expected.colorModel.hasAlpha(), actual.hasAlpha)
        // Not getRGB, which converts grey from linear light; the colours of a palette are taken from it.
        val grey = expected.type == BufferedImage.TYPE_BYTE_GRAY
        val wanted =
            ByteArray(4 * expected.width * expected.height) { i ->
                val (x, y) = i / 4 % expected.width to i / 4 / expected.width
                if (grey && i % 4 < 3) expected.raster.getSample(x, y, 0).toByte() else (expected.getRGB(x, y) shr SHIFTS[i % 4]).toByte()
            }
        assertArrayEquals(wanted, actual.image.rgba)
    }

    private fun noise(
        width: Int,
        height: Int,
        type: Int,
    ): BufferedImage {
        val image = BufferedImage(width, height, type)
        val random = Random(width)
        // A ramp with a little noise, so that every filter is the best for some row.
        for (y in 0 until height) for (x in 0 until width) image.setRGB(x, y, 0x03050709 * (x + y * y) + random.nextInt(-2, 3))
        return image
    }

    private fun written(
        image: BufferedImage,
        interlaced: Boolean,
    ): ByteArray {
        val out = ByteArrayOutputStream()
        val writer = ImageIO.getImageWritersByFormatName("png").next()
        MemoryCacheImageOutputStream(out).use { stream ->
            writer.output = stream
            val settings = writer.defaultWriteParam
            settings.progressiveMode = if (interlaced) ImageWriteParam.MODE_DEFAULT else ImageWriteParam.MODE_DISABLED
            val metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), settings)
            val gamma = IIOMetadataNode("gAMA").apply { setAttribute("value", "100000") }
            metadata.mergeTree("javax_imageio_png_1.0", IIOMetadataNode("javax_imageio_png_1.0").apply { appendChild(gamma) })
            writer.write(null, IIOImage(image, null, metadata), settings)
        }
        writer.dispose()
        return out.toByteArray()
    }

    private companion object {
        val SHIFTS = listOf(16, 8, 0, 24)
    }
}

package cga.imaging.file

import cga.framework.InputError
import cga.framework.image.ExrFile
import cga.framework.image.FloatImage
import cga.imaging.FloatPicture
import cga.imaging.PictureFile
import cga.imaging.file.ExrBytes.Companion.floats
import cga.imaging.file.ExrBytes.Companion.halves
import cga.imaging.file.ExrBytes.Companion.zipped
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.math.pow
import kotlin.random.Random

class ExrReaderTest {
    private val rgb = floats(3f, 2f, 1f)

    /** Another's encoder (TinyEXR's) against our decoder. */
    @Test
    fun `what the program writes is read bit for bit`(
        @TempDir folder: Path,
    ) {
        // More than two blocks of 16 rows, and noise beside a flat part: some blocks do not become smaller and are stored as they are.
        for ((width, height) in listOf(1 to 1, 13 to 35, 64 to 48)) {
            val random = Random(width)
            val rgba = FloatArray(4 * width * height) { if (it < 2 * width * height) Float.fromBits(random.nextInt() and FINITE) else 0.5f }
            floatArrayOf(0f, -0f, 1e-45f, -3.4028235e38f).copyInto(rgba)
            val file = folder.resolve("picture.exr")
            ExrFile.write(FloatImage(width, height, rgba), file)
            assertPixels(true, rgba, file.readBytes())
        }
    }

    @Test
    fun `channels go to their places`() {
        assertPixels(false, floatArrayOf(1f, 2f, 3f, 1f), ExrBytes(1, 1).of(rgb))
        val alpha = ExrBytes(1, 1).apply { channels = listOf("A" to 2, "B" to 2, "G" to 2, "R" to 2) }
        assertPixels(true, floatArrayOf(1f, 2f, 3f, 0.5f), alpha.of(floats(0.5f, 3f, 2f, 1f)))
        assertPixels(false, floatArrayOf(7f, 7f, 7f, 1f), ExrBytes(1, 1).apply { channels = listOf("Y" to 2) }.of(floats(7f)))
        val grey = ExrBytes(1, 1).apply { channels = listOf("A" to 2, "Y" to 2) }
        assertPixels(true, floatArrayOf(7f, 7f, 7f, 0.5f), grey.of(floats(0.5f, 7f)))
    }

    @Test
    fun `halves and floats may stand beside each other`() {
        val mixed = ExrBytes(2, 1).apply { channels = listOf("B" to 1, "G" to 2, "R" to 1) }
        val file = mixed.of(halves(0x3C00, 0xC000) + floats(0.1f, 0.2f) + halves(0x3555, 0x0001))
        assertPixels(false, floatArrayOf(0.33325195f, 0.1f, 1f, 1f, 2f.pow(-24), 0.2f, -2f, 1f), file)
    }

    /** By the definition of binary16: (−1)^sign · 2^(exponent − 15) · 1.fraction, and 2⁻¹⁴ · 0.fraction below. */
    @Test
    fun `every half becomes its float`() {
        for (bits in 0..0xFFFF) {
            val (exponent, fraction) = (bits shr 10 and 31) to (bits and 1023) / 1024.0
            val size =
                when {
                    exponent == 31 && fraction > 0 -> Double.NaN
                    exponent == 31 -> Double.POSITIVE_INFINITY
                    exponent == 0 -> 2.0.pow(-14) * fraction
                    else -> 2.0.pow(exponent - 15) * (1 + fraction)
                }
            val expected = if (bits < 0x8000) size else -size
            assertEquals(expected.toFloat(), ExrReader.halfToFloat(bits), "bits $bits")
        }
    }

    @Test
    fun `each compression is undone`() {
        val picture = FloatArray(4 * 2 * 17) { if (it % 4 == 3) 1f else it / 4 + it % 4 / 8f }
        val rows = List(17) { y -> List(3) { c -> List(2) { x -> picture[4 * (2 * y + x) + 2 - c] } }.flatten() }
        val plain = rows.map { floats(*it.toFloatArray()) }
        assertPixels(false, picture, ExrBytes(2, 17).of(*plain.toTypedArray()))
        assertPixels(false, picture, ExrBytes(2, 17).apply { compression = 2 }.of(*plain.map { zipped(it) }.toTypedArray()))
        val blocks = plain.chunked(16) { it.reduce(ByteArray::plus) }
        assertPixels(false, picture, ExrBytes(2, 17).apply { compression = 3 }.of(*blocks.map { zipped(it) }.toTypedArray()))
    }

    @Test
    fun `a picture need not begin at row 0`() {
        assertPixels(false, floatArrayOf(1f, 2f, 3f, 1f), ExrBytes(1, 1).apply { top = -5 }.of(rgb))
    }

    @Test
    fun `values that are not finite are refused with the first of them and their number`() {
        val file = ExrBytes(2, 2).of(floats(0f, 0f, 0f, Float.POSITIVE_INFINITY, 0f, 0f), floats(0f, 0f, 0f, 0f, Float.NaN, 0f))
        assertRefused(file, "2 values are not finite", "the first: Infinity in green at x = 1, y = 0")
        assertRefused(ExrBytes(2, 1).of(floats(0f, 0f, 0f, 0f, 0f, Float.NaN)), "1 value is not finite: NaN in red at x = 1, y = 0")
    }

    @TestFactory
    fun `a kind that is not read is refused with its name`(): List<DynamicTest> =
        listOf(
            Refused("tiles", ExrBytes(1, 1).apply { version = 0x202 }.of(rgb), "stored in tiles"),
            Refused("deep", ExrBytes(1, 1).apply { version = 0x802 }.of(rgb), "a deep picture"),
            Refused("parts", ExrBytes(1, 1).apply { version = 0x1002 }.of(rgb), "of several parts"),
            Refused("a flag that is not known", ExrBytes(1, 1).apply { version = 0x2002 }.of(rgb), "of an unknown kind"),
            Refused("another version", ExrBytes(1, 1).apply { version = 3 }.of(rgb), "of version 3"),
            Refused("a lossy compression", ExrBytes(1, 1).apply { compression = 9 }.of(rgb), "compression is DWAB", "save it with ZIP"),
            Refused("a compression that is none", ExrBytes(1, 1).apply { compression = -7 }.of(rgb), "compression is unknown (-7)"),
            Refused("depth", ExrBytes(1, 1).apply { channels = listOf("Z" to 2) }.of(rgb), "channels are Z, not RGB"),
            Refused("no channels", ExrBytes(1, 1).apply { channels = listOf() }.of(), "channels are none"),
            Refused("a strange name", ExrBytes(1, 1).apply { channels = listOf("\u001B[m" to 2) }.of(rgb), "channels are ?[m"),
            Refused("disorder", ExrBytes(1, 1).apply { channels = channels.reversed() }.of(rgb), "channels are R, G, B"),
            Refused("whole numbers", ExrBytes(1, 1).apply { channels = listOf("Y" to 0) }.of(rgb), "Y has whole numbers"),
            Refused("a type that is none", ExrBytes(1, 1).apply { channels = listOf("Y" to 3) }.of(rgb), "Y is of the unknown type 3"),
            Refused("fewer pixels", ExrBytes(1, 1).apply { sampling = 2 }.of(rgb), "B has fewer pixels"),
            Refused("a crop", ExrBytes(1, 1).apply { displayWindow = listOf(0, 0, 1, 1) }.of(rgb), "[0, 0, 0, 0]", "[0, 0, 1, 1]"),
            Refused("gigantic", ExrBytes(100_000, 100_000).of(rgb), "100000x100000", "$MAX_PIXELS pixels", "smaller"),
            Refused("the whole plane", ExrBytes(1, 1).apply { dataWindow = WHOLE }.of(rgb), "4294967296x4294967296", "smaller"),
            Refused("inside out", ExrBytes(1, 1).apply { dataWindow = listOf(1, 1, 0, 0) }.of(rgb), "size is 0x0"),
        ).map { dynamicTest(it.what) { assertRefused(it.file, *it.parts) } }

    @TestFactory
    fun `a file that is not whole is refused with its reason`(): List<DynamicTest> {
        val sound = ExrBytes(1, 1).of(rgb)
        val table = sound.size - 20 - 8
        val zip = ExrBytes(1, 1).apply { compression = 3 }
        return listOf(
            Refused("large and empty", ExrBytes(8192, 4096).of(rgb), "bytes of data are too few for its size"),
            Refused("no row", ExrBytes(1, 1).of(), "cut off after"),
            Refused("a row missing", ExrBytes(1, 2).of(rgb), "row 1 is missing"),
            Refused("a zero in the table", sound.copyOf().also { it[table] = 0 }, "row 0 is missing"),
            Refused("a place behind the end", sound.copyOf().also { it[table + 5] = 1 }, "row 0 is missing"),
            Refused("another row", sound.copyOf().also { it[table + 8] = 1 }, "another row in the place of row 0"),
            Refused("too little for a row", ExrBytes(1, 1).of(rgb.copyOf(8)), "8 bytes for row 0, not 12"),
            Refused("too much for a row", ExrBytes(1, 1).of(rgb + rgb), "24 bytes for row 0, not 12"),
            Refused("zlib ends early", zip.of(deflated(bytes(1))), "data end too early"),
            Refused("not zlib", zip.of(bytes(1, 2, 3)), "data are damaged"),
            Refused("no compression", ExrBytes(1, 1).apply { without = setOf("compression") }.of(rgb), "has no compression"),
            Refused("no channel list", ExrBytes(1, 1).apply { without = setOf("channels") }.of(rgb), "has no channels"),
            Refused("no size", ExrBytes(1, 1).apply { without = setOf("dataWindow") }.of(rgb), "has no dataWindow"),
        ).map { dynamicTest(it.what) { assertRefused(it.file, *it.parts) } }
    }

    @Test
    fun `no file cut off anywhere is taken for a picture`() {
        val file = ExrBytes(2, 17).apply { compression = 3 }.of(zipped(ByteArray(2 * 12 * 16)), zipped(ByteArray(2 * 12)))
        PictureFile.decode(file)
        for (length in 0 until file.size) assertRefused(file.copyOf(length), "save it again.")
    }

    private class Refused(
        val what: String,
        val file: ByteArray,
        vararg val parts: String,
    )

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
        expected: FloatArray,
        file: ByteArray,
    ) {
        val picture = PictureFile.decode(file) as FloatPicture
        assertArrayEquals(expected.map { it.toRawBits() }.toIntArray(), picture.image.rgba.map { it.toRawBits() }.toIntArray())
        assertEquals(hasAlpha, picture.hasAlpha)
    }

    private companion object {
        /** Clears the exponent's last bit: no infinity and no NaN is left. */
        const val FINITE = -0x00800001
        val WHOLE = listOf(Int.MIN_VALUE, Int.MIN_VALUE, Int.MAX_VALUE, Int.MAX_VALUE)
    }
}

package cga.framework.image

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.system.MemoryStack
import org.lwjgl.util.tinyexr.EXRHeader
import org.lwjgl.util.tinyexr.EXRImage
import org.lwjgl.util.tinyexr.EXRVersion
import org.lwjgl.util.tinyexr.TinyEXR.*
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.random.Random

class ExrFileTest {
    // More than 16 rows, which is a block of this compression.
    private val width = 13
    private val height = 35
    private val rgba = FloatArray(4 * width * height) { Random(it).nextFloat() * 1000 - 500 }

    @Test
    fun `every float comes back, bit for bit`(
        @TempDir folder: Path,
    ) {
        val special = floatArrayOf(0f, -0f, 1e-45f, -3.4e38f, 3.4028235e38f, 65505f, 1f / 3, Float.POSITIVE_INFINITY)
        special.copyInto(rgba)
        val file = folder.resolve("picture.exr")
        ExrFile.write(FloatImage(width, height, rgba), file)
        assertEquals(listOf(file), folder.listDirectoryEntries())
        assertArrayEquals(rgba.map { it.toRawBits() }.toIntArray(), readExr(file).rgba.map { it.toRawBits() }.toIntArray())
    }

    @Test
    fun `numbers that do not fit the size are refused`() {
        val message = assertThrows<IllegalArgumentException> { FloatImage(2, 2, FloatArray(15)) }.message.orEmpty()
        assertTrue("2x2" in message && "15" in message, message)
    }
}

/** The picture in [file], whose channels must be A, B, G and R and hold floats. */
fun readExr(file: Path): FloatImage =
    MemoryStack.stackPush().use { stack ->
        val error = stack.callocPointer(1)
        val version = EXRVersion.calloc(stack)
        assertEquals(TINYEXR_SUCCESS, ParseEXRVersionFromFile(version, "$file"))
        val header = EXRHeader.calloc(stack)
        InitEXRHeader(header)
        assertEquals(TINYEXR_SUCCESS, ParseEXRHeaderFromFile(header, version, "$file", error))
        val names = List(header.num_channels()) { header.channels()[it].nameString() }
        assertEquals(listOf("A", "B", "G", "R"), names)
        for (i in names.indices) assertEquals(TINYEXR_PIXELTYPE_FLOAT, header.pixel_types()[i])
        val image = EXRImage.calloc(stack)
        InitEXRImage(image)
        assertEquals(TINYEXR_SUCCESS, LoadEXRImageFromFile(image, header, "$file", error))
        val pixels = image.width() * image.height()
        val planes = List(4) { c -> checkNotNull(image.images()).getFloatBuffer("ABGR".indexOf("RGBA"[c]), pixels) }
        FloatImage(image.width(), image.height(), FloatArray(4 * pixels) { planes[it % 4][it / 4] }).also {
            FreeEXRImage(image)
            FreeEXRHeader(header)
        }
    }

package cga.framework.image

import cga.testing.assertRefused
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.file.Path
import java.util.zip.CRC32
import javax.imageio.ImageIO
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.random.Random

/** Animated pictures, taken apart by the letter of the specification: each frame becomes a PNG of its own, which the JDK decodes. */
class ApngFileTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `every frame is decoded back to its pixels`() {
        val images = List(5) { ImageData(31, 70, Random(it).nextBytes(4 * 31 * 70)) }
        val chunks = chunks(write(images, 25.0))
        assertEquals("IHDR", chunks.first().type)
        assertEquals("IEND", chunks.last().type)
        val control = chunks.single { it.type == "acTL" }
        assertEquals(listOf(5, 0), List(2) { control.content.getInt(4 * it) })
        for ((i, frame) in frames(chunks).withIndex()) {
            val decoded = ImageIO.read(frame.inputStream())
            val expected = images[i]
            for (pixel in 0 until 31 * 70) {
                val (r, g, b) = List(3) { expected.rgba[4 * pixel + it].toInt() and 0xFF }
                assertEquals(0xFF shl 24 or (r shl 16) or (g shl 8) or b, decoded.getRGB(pixel % 31, pixel / 31), "frame $i, pixel $pixel")
            }
        }
        // What knows PNG only shows the first picture.
        val still = ImageIO.read(folder.resolve("a.apng").toFile())
        assertEquals(31 to 70, still.width to still.height)
    }

    @Test
    fun `sequence numbers go up by one, and every frame says size and delay`() {
        for ((fps, delay) in listOf(30.0 to 3000, 12.5 to 1250, 0.5 to 50)) {
            val chunks = chunks(write(List(3) { ImageData(4, 3, ByteArray(48)) }, fps))
            val numbered = chunks.filter { it.type == "fcTL" || it.type == "fdAT" }
            assertEquals(numbered.indices.toList(), numbered.map { it.content.getInt(0) })
            for (control in chunks.filter { it.type == "fcTL" }) {
                assertEquals(listOf(4, 3, 0, 0), List(4) { control.content.getInt(4 + 4 * it) })
                assertEquals(100 to delay, control.content.getShort(20).toInt() to control.content.getShort(22).toInt())
                assertEquals(26, control.content.capacity())
            }
        }
    }

    @Test
    fun `what cannot be an animation is refused, and leaves no file`() {
        val image = ImageData(2, 2, ByteArray(16))
        val file = folder.resolve("b.apng")
        assertRefused(0) { ApngFile.write(file, 0, 30.0) { image } }
        assertRefused(1000.0) { ApngFile.write(file, 1, 1000.0) { image } }
        assertRefused("3x2", "2x2") { ApngFile.write(file, 2, 30.0) { if (it == 0) image else ImageData(3, 2, ByteArray(24)) } }
        assertThrows<IllegalStateException> { ApngFile.write(file, 2, 30.0) { if (it == 0) image else error("no picture") } }
        assertEquals(false, file.exists())
    }

    private fun write(images: List<ImageData>, fps: Double): ByteArray {
        val file = folder.resolve("a.apng")
        ApngFile.write(file, images.size, fps) { images[it] }
        return file.readBytes()
    }

    private class Chunk(val type: String, val content: ByteBuffer) {
        fun bytes() = ByteArray(content.capacity()) { content[it] }
    }

    private fun chunks(file: ByteArray): List<Chunk> {
        val buffer = ByteBuffer.wrap(file)
        assertArrayEquals(SIGNATURE, ByteArray(8).also { buffer.get(it) })
        val chunks = ArrayList<Chunk>()
        while (buffer.hasRemaining()) {
            val bytes = ByteArray(buffer.getInt())
            val type = ByteArray(4).also { buffer.get(it) }
            buffer.get(bytes)
            val checksum = CRC32().apply { update(type) }.apply { update(bytes) }
            assertEquals(checksum.value.toInt(), buffer.getInt(), "checksum of ${type.decodeToString()}")
            chunks += Chunk(type.decodeToString(), ByteBuffer.wrap(bytes))
        }
        return chunks
    }

    /** Each frame as a PNG file. */
    private fun frames(chunks: List<Chunk>): List<ByteArray> {
        val frames = ArrayList<MutableList<ByteArray>>()
        for (chunk in chunks) {
            when (chunk.type) {
                "fcTL" -> frames += mutableListOf<ByteArray>()
                "IDAT" -> frames.last() += chunk.bytes()
                "fdAT" -> frames.last() += chunk.bytes().drop(4).toByteArray()
            }
        }
        return frames.map { data ->
            ByteArrayOutputStream()
                .also { file ->
                    file.write(SIGNATURE)
                    PngFile.chunk(file, "IHDR", listOf(chunks.first().bytes()))
                    PngFile.chunk(file, "IDAT", data)
                    PngFile.chunk(file, "IEND", emptyList())
                }.toByteArray()
        }
    }

    private companion object {
        val SIGNATURE = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A)
    }
}

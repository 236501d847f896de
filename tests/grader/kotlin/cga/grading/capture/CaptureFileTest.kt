package cga.grading.capture

import cga.testing.Slow
import com.sun.management.ThreadMXBean
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import org.lwjgl.opengl.GL33C.*
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.lang.management.ManagementFactory
import java.nio.file.Path
import java.util.zip.DeflaterOutputStream
import java.util.zip.InflaterInputStream
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.random.Random

@Slow
class CaptureFileTest {
    @TempDir
    private lateinit var folder: Path
    private val file get() = folder.resolve("capture")

    private fun written(capture: Capture = SampleCapture.capture()): ByteArray {
        CaptureFile.write(capture, file)
        return file.readBytes()
    }

    private fun read(bytes: ByteArray): Capture {
        file.writeBytes(bytes)
        return CaptureFile.read(file)
    }

    private fun refusal(bytes: ByteArray): String = assertThrows<BadCapture> { read(bytes) }.message.orEmpty()

    @Test
    fun `what is read is what was written`() {
        val read = read(written())
        assertEquals(listOf(4, 3, 4), listOf(read.width, read.height, read.samples))
        val draw = read.frames[0].steps[1] as CapturedDraw
        assertEquals(SampleCapture.state, draw.state)
        assertEquals(mapOf(3 to 0), draw.textures)
        assertEquals("lights[1].color", draw.uniforms[0].name)
        assertArrayEquals(SampleCapture.uniforms[0].numbers, draw.uniforms[0].numbers)
        assertArrayEquals(floatArrayOf(0f, 0.25f, 0.5f, 1f), (read.frames[0].steps[0] as CapturedClear).color)
        assertArrayEquals(SampleCapture.capture().frames[0].picture, read.frames[0].picture)
        assertEquals(SampleCapture.limited, (read.frames[0].steps[2] as CapturedClear).writes)
        assertEquals(listOf(false to GL_REPEAT, true to GL_CLAMP_TO_EDGE), read.textures.map { it.isCube to it.wrapR })
        assertNull(read.frames[1].picture)
        assertEquals(Moment.TIME_1 to 0.7, read.frames[1].moment to read.frames[1].time)
        assertEquals(Triple(EventKind.UNIFORM_ABSENT, 0, "früh"), read.events[0].let { Triple(it.kind, it.frame, it.text) })
        assertEquals(mapOf("position" to 1) to mapOf("color" to 1), read.programs[0].let { it.attributes to it.outputs })
        assertEquals(listOf("light/Lamp.kt:3", "game/Scene.kt:8"), read.chain(draw.uniforms[0].caller))
        assertEquals(listOf(0, 1, 0), draw.callers.run { listOf(this.draw, program, textures[3]) })
        assertEquals(emptyList<String>(), read.chain(draw.uniforms[1].caller))
        // Whatever the lines above do not name must be there too, or the second file would be another.
        assertArrayEquals(written(), written(read))
    }

    @Test
    fun `nothing is left beside the file`() {
        written()
        assertEquals(listOf(file), folder.listDirectoryEntries())
    }

    @Test
    fun `a file that ends early is refused wherever it ends`() {
        val bytes = written()
        for (length in bytes.indices) refusal(bytes.copyOf(length))
    }

    @Test
    fun `bytes after the end are refused, deflated or not`() {
        assertEquals("something follows the end of the capture", refusal(written() + 0))
        assertEquals("something follows the end of the capture", refusal(deflated(inflated(written()) + 0)))
    }

    @Test
    fun `another version is refused`() {
        val bytes = written()
        bytes[7]++
        assertEquals("this is not a capture file of this version", refusal(bytes))
    }

    @Test
    fun `a damaged file is refused or read, and never anything else`() {
        val good = written()
        val random = Random(4)
        var refused = 0
        repeat(4000) {
            // Half of the damage is inside, where no checksum of the compression finds it.
            val bytes = if (it % 2 == 0) good.copyOf() else inflated(good)
            repeat(random.nextInt(1, 4)) { bytes[random.nextInt(bytes.size)] = random.nextInt().toByte() }
            try {
                read(if (it % 2 == 0) bytes else deflated(bytes))
            } catch (_: BadCapture) {
                refused++
            }
        }
        // Most bytes are numbers, and pictures and shader texts may be anything.
        assertTrue(refused in 2000 until 4000, "$refused of 4000 were refused")
    }

    @Test
    fun `a small file that claims to be large takes no memory`() {
        val claims = ByteArrayOutputStream()
        DataOutputStream(claims).run {
            for (number in listOf(8, 8, 0, 0, 1, 500_000_000)) writeInt(number)
        }
        val bytes = deflated(claims.toByteArray())
        val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean
        val before = threads.currentThreadAllocatedBytes
        assertEquals("the capture ends too early", refusal(bytes))
        // Three buffers of 64 KiB are allocated for a start, none of 500 MB.
        assertTrue(threads.currentThreadAllocatedBytes - before < 1 shl 20)
    }

    @Test
    fun `a capture beyond the limit is refused while it is read`() {
        written()
        val size = inflated(file.readBytes()).size.toLong()
        CaptureFile.read(file, size)
        assertEquals("the capture is larger than allowed", assertThrows<BadCapture> { CaptureFile.read(file, size - 1) }.message)
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("unfit")
    fun `parts that do not fit are refused`(
        reason: String,
        capture: Capture,
    ) {
        val message = refusal(written(capture))
        assertTrue(reason in message, message)
    }

    private fun inflated(bytes: ByteArray) = InflaterInputStream(bytes.inputStream(8, bytes.size - 8)).readAllBytes()

    private fun deflated(payload: ByteArray): ByteArray {
        val out = ByteArrayOutputStream()
        DataOutputStream(out).writeLong(0x4347414341500002L)
        DeflaterOutputStream(out).use { it.write(payload) }
        return out.toByteArray()
    }

    private companion object {
        @JvmStatic
        fun unfit(): List<Array<Any>> {
            val s = SampleCapture

            fun draw(draw: CapturedDraw) = s.capture(listOf(draw))

            fun texture(texture: CapturedTexture) = s.capture(textures = listOf(texture))
            return listOf(
                arrayOf("program is 1", draw(s.draw(program = 1))),
                arrayOf("mode is 7", draw(s.draw(mode = GL_QUADS))),
                arrayOf("texture is not there", draw(s.draw(textures = mapOf(0 to 2)))),
                arrayOf("two uniforms", draw(s.draw(uniforms = s.uniforms + s.uniforms))),
                arrayOf("two attributes", draw(s.draw(attributes = listOf(s.attribute(), s.attribute())))),
                arrayOf("attribute's buffer is 2", draw(s.draw(attributes = listOf(s.attribute(buffer = 2))))),
                arrayOf("reads vertex 3 outside of buffer 0", draw(s.draw(attributes = listOf(s.attribute(offset = 4))))),
                arrayOf("reads vertex 3 outside of buffer 0", draw(s.draw(attributes = listOf(s.attribute(stride = 13))))),
                arrayOf("reads vertex 3 outside of buffer 0", draw(s.draw(attributes = listOf(s.attribute(size = 4))))),
                arrayOf("reads vertex 3 outside of buffer 0", draw(s.draw(attributes = listOf(s.attribute(offset = Long.MAX_VALUE))))),
                arrayOf("reads vertex 3 outside of buffer 0", draw(s.draw(attributes = listOf(s.attribute(offset = -12))))),
                arrayOf("reads vertex 4 outside of buffer 0", draw(s.draw(baseVertex = 1))),
                arrayOf("outside of index buffer 1", draw(s.draw(count = 7))),
                arrayOf("outside of index buffer 1", draw(s.draw(first = 1))),
                arrayOf("outside of index buffer 1", draw(s.draw(first = -1))),
                arrayOf("outside of index buffer 1", draw(s.draw(count = Int.MAX_VALUE))),
                arrayOf("index buffer is 2", draw(s.draw(indices = 2))),
                arrayOf("of type 5126", draw(s.draw(indexType = GL_FLOAT))),
                arrayOf("reads vertex 4 outside of buffer 0", draw(s.draw(indices = null, count = 5))),
                arrayOf("base vertex is -1", draw(s.draw(baseVertex = -1))),
                arrayOf("depth function is 520", draw(s.draw(state = s.state.copy(depthFunc = 520)))),
                arrayOf("cull mode is 5", draw(s.draw(state = s.state.copy(cullMode = 5)))),
                arrayOf("front face is 5", draw(s.draw(state = s.state.copy(frontFace = 5)))),
                arrayOf("polygon mode is 5", draw(s.draw(state = s.state.copy(polygonMode = 5)))),
                arrayOf("blend factor", draw(s.draw(state = s.state.copy(blendSource = 5)))),
                arrayOf("viewport", draw(s.draw(state = s.state.copy(viewport = listOf(0, 0, -1, 3))))),
                arrayOf("unknown type 1", draw(s.draw(uniforms = listOf(UniformValue("u", 1, floatArrayOf(1f)))))),
                arrayOf("clear's mask is 1", s.capture(listOf(s.clear(mask = 1)))),
                arrayOf("scissor box", s.capture(listOf(s.clear(writes = WriteMask(listOf(0, 0, -1, 3), 15))))),
                arrayOf("scissor box", draw(s.draw(state = s.state.copy(writes = WriteMask(listOf(0, 0), 15))))),
                arrayOf("mask of channels is 16", draw(s.draw(state = s.state.copy(writes = WriteMask(null, 16))))),
                arrayOf("clear's depth is NaN", s.capture(listOf(s.clear(depth = Double.NaN)))),
                arrayOf("has no level", texture(s.texture(levels = emptyList()))),
                arrayOf("level 0 of a 2x1 texture has 7 bytes", texture(s.texture(levels = listOf(ByteArray(7))))),
                arrayOf("more levels", texture(s.texture(levels = listOf(ByteArray(8), ByteArray(4), ByteArray(4))))),
                arrayOf("texture's width is 8193", texture(s.texture(width = 8193, levels = listOf(ByteArray(8193 * 4))))),
                arrayOf("cube map is 2x1", texture(s.cube(height = 1, bytes = 48))),
                arrayOf("level 0 of a 2x2 texture has 80 bytes", texture(s.cube(bytes = 80))),
                arrayOf("wraps", texture(s.texture(wrap = GL_LINEAR))),
                arrayOf("minFilter is 1", texture(s.texture(minFilter = 1))),
                arrayOf("magFilter is 9987", texture(s.texture(magFilter = GL_LINEAR_MIPMAP_LINEAR))),
                arrayOf("anisotropy is 17.0", texture(s.texture(anisotropy = 17f))),
                arrayOf("anisotropy is NaN", texture(s.texture(anisotropy = Float.NaN))),
                arrayOf("picture has the wrong size", s.capture(picture = ByteArray(4))),
                arrayOf("the size of a picture is 49", s.capture(picture = ByteArray(49))),
                arrayOf("window's width is 0", s.capture(width = 0, picture = null)),
                arrayOf("frame 2", s.capture(events = listOf(CapturedEvent(EventKind.GL_ERROR, 2, "")))),
                arrayOf("2001 characters", s.capture(events = listOf(CapturedEvent(EventKind.GL_ERROR, 0, "x".repeat(2001))))),
                arrayOf(
                    "the number of uniforms is 16385",
                    draw(s.draw(uniforms = List(16_385) { UniformValue("$it", GL_FLOAT, floatArrayOf(0f)) })),
                ),
                arrayOf("caller 2 is not there", draw(s.draw(callers = DrawCallers(2, 0, emptyMap())))),
                arrayOf("caller 2 is not there", draw(s.draw(callers = DrawCallers(0, 0, mapOf(1 to 2))))),
                arrayOf("caller 2 is not there", draw(s.draw(uniforms = listOf(UniformValue("u", GL_FLOAT, floatArrayOf(0f), 2))))),
                arrayOf("a caller is 4096", draw(s.draw(callers = DrawCallers(4096, 0, emptyMap())))),
                arrayOf("the number of calls is 9", s.capture(callers = List(2) { List(9) { "a.kt:1" } })),
                arrayOf("a call has 201 characters", s.capture(callers = List(2) { listOf("x".repeat(201)) })),
                arrayOf("the number of chains of calls is 4097", s.capture(callers = List(4097) { listOf("a.kt:1") })),
                arrayOf("the number of steps is 16385", s.capture(List(16_385) { s.clear() })),
            )
        }

        const val GL_QUADS = 7
    }
}

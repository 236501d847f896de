package cga.grading.replay

import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.ImageData
import cga.grading.capture.Capture
import cga.grading.capture.CapturedAttribute
import cga.grading.capture.CapturedClear
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import cga.grading.capture.CapturedProgram
import cga.grading.capture.CapturedTexture
import cga.grading.capture.DrawState
import cga.grading.capture.Moment
import cga.grading.capture.UniformValue
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Two draws over a black picture: the left half gets map·a, and the lower half then b. */
@ExtendWith(Offscreen::class)
class ReplayTest {
    private val vertex = "#version 330 core\nin vec2 place;\nvoid main() { gl_Position = vec4(place, 0.0, 1.0); }\n"
    private val textured =
        "#version 330 core\nuniform sampler2D map;\nuniform vec4 color[2];\nout vec4 result;\n" +
            "void main() { result = texture(map, vec2(0.25)) * color[1]; }\n"
    private val plain = "#version 330 core\nuniform vec4 color;\nout vec4 result;\nvoid main() { result = color; }\n"
    private val state = DrawState(listOf(0, 0, 8, 8), false, GL_LESS, true, false, GL_BACK, GL_CCW, false, GL_ONE, GL_ZERO, GL_FILL, false)
    private val first =
        draw(0, 0, listOf(UniformValue("map", GL_SAMPLER_2D, floatArrayOf(5f)), color("color[1]", 1f, 1f, 0f)), mapOf(5 to 0))
    private val second = draw(1, 1, listOf(color("color", 0f, 0f, 1f)), emptyMap())

    private fun color(
        name: String,
        red: Float,
        green: Float,
        blue: Float,
    ) = UniformValue(name, GL_FLOAT_VEC4, floatArrayOf(red, green, blue, 1f))

    private fun draw(
        program: Int,
        buffer: Int,
        uniforms: List<UniformValue>,
        textures: Map<Int, Int>,
    ) = CapturedDraw(
        program, GL_TRIANGLE_STRIP, 4, listOf(CapturedAttribute(0, 2, GL_FLOAT, false, 0, 0, buffer)), null, 0, 0, 0, 1, uniforms, textures,
        state,
    )

    private fun floats(vararg numbers: Float) =
        ByteBuffer.allocate(4 * numbers.size).order(ByteOrder.LITTLE_ENDIAN).also { numbers.forEach(it::putFloat) }.array()

    private fun capture(fragment: String = plain) =
        Capture(
            width = 8,
            height = 8,
            programs = listOf(textured, fragment).map { CapturedProgram(vertex, it, mapOf("place" to 0)) },
            buffers = listOf(floats(-1f, -1f, 0f, -1f, -1f, 1f, 0f, 1f), floats(-1f, -1f, 1f, -1f, -1f, 0f, 1f, 0f)),
            textures =
                listOf(
                    CapturedTexture(1, 1, listOf(byteArrayOf(-1, 51, -1, -1)), GL_REPEAT, GL_REPEAT, GL_NEAREST, GL_NEAREST),
                ),
            frames =
                listOf(
                    CapturedFrame(
                        Moment.FIRST,
                        0.0,
                        listOf(CapturedClear(GL_COLOR_BUFFER_BIT, floatArrayOf(0f, 0f, 0f, 1f), 1.0), first, second),
                        null,
                    ),
                ),
            events = emptyList(),
        )

    /** The colours in the middles of the four quarters, from the top left, row by row, as RGB in hexadecimal. */
    private fun quarters(
        change: Change = Change.NONE,
        side: Int = 8,
    ): List<String> =
        RenderTarget(side, side).use { target ->
            Replay(capture()).use { it.draw(0, target, change) }
            val picture = target.read()
            val (low, high) = side / 4 to 3 * side / 4
            listOf(low to low, high to low, low to high, high to high).map { (x, y) ->
                (0 until 3).joinToString("") { "%02x".format(picture.rgba[4 * (y * side + x) + it]) }
            }
        }

    @Test
    fun `a frame is drawn as it was captured, at any size`() {
        val expected = listOf("ff3300", "000000", "0000ff", "0000ff")
        assertEquals(expected, quarters())
        assertEquals(expected, quarters(side = 40))
    }

    @Test
    fun `uniforms can be changed by name`() {
        val change = Change.uniforms(mapOf("color[1]" to floatArrayOf(0f, 0f, 1f, 1f)))
        assertEquals(listOf("0000ff", "000000", "0000ff", "0000ff"), quarters(change))
    }

    @Test
    fun `a draw can be left out`() {
        val change =
            object : Change() {
                override fun isDrawn(
                    step: Int,
                    draw: CapturedDraw,
                ) = step != 2
            }
        assertEquals(listOf("ff3300", "000000", "ff3300", "000000"), quarters(change))
    }

    @Test
    fun `a texture can be replaced`() {
        val white = ImageData.ofColor(1f, 1f, 1f)
        val change =
            object : Change() {
                override fun texture(
                    step: Int,
                    draw: CapturedDraw,
                    unit: Int,
                ) = white.takeIf { unit == 5 }
            }
        assertEquals(listOf("ffff00", "000000", "0000ff", "0000ff"), quarters(change))
    }

    @Test
    fun `a program can be replaced, and uniforms that it lacks are passed over`() {
        val green = CapturedProgram(vertex, plain.replace("= color;", "= vec4(0.0, 1.0, 0.0, 1.0);"), mapOf("place" to 0))
        val change =
            object : Change() {
                override fun program(
                    step: Int,
                    draw: CapturedDraw,
                    captured: CapturedProgram,
                ) = if (step == 1) green else captured
            }
        assertEquals(listOf("00ff00", "000000", "0000ff", "0000ff"), quarters(change))
    }

    @Test
    fun `a float target holds what a byte cannot`() {
        RenderTarget(8, 8, format = ColorFormat.RGBA32F).use { target ->
            Replay(capture()).use { it.draw(0, target, Change.uniforms(mapOf("color" to floatArrayOf(-3f, 7f, 0.001f, 1f)))) }
            assertEquals(listOf(-3f, 7f, 0.001f), target.readFloats().rgba.takeLast(4).take(3))
        }
    }

    @Test
    fun `GLSL that does not compile is one error, and so is a sampler of no unit`() {
        RenderTarget(8, 8).use { target ->
            val broken = assertThrows<ReplayError> { Replay(capture(plain.replace("out", "owt"))).use { it.draw(0, target) } }
            assertTrue("does not compile" in broken.message.orEmpty(), broken.message)
            val refused =
                assertThrows<ReplayError> {
                    Replay(
                        capture(),
                    ).use { it.draw(0, target, Change.uniforms(mapOf("map" to floatArrayOf(1e9f)))) }
                }
            assertTrue("frame 0" in refused.message.orEmpty(), refused.message)
        }
    }
}

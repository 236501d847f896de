package cga.framework

import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*

@ExtendWith(Offscreen::class)
class RenderTargetTest {
    @Test
    fun `the picture is read with the top row first`() {
        for (samples in listOf(0, 4)) {
            RenderTarget(2, 2, samples).use { target ->
                clear(0f, 0f, 0f)
                glEnable(GL_SCISSOR_TEST)
                // OpenGL counts from below: the pixel at the top left.
                glScissor(0, 1, 1, 1)
                clear(1f, 0.4f, 0f)
                glDisable(GL_SCISSOR_TEST)
                val black = listOf(0, 0, 0, 255)
                assertEquals(
                    listOf(255, 102, 0, 255) + black + black + black,
                    target.read().rgba.map { it.toInt() and 0xFF },
                    "$samples samples",
                )
            }
        }
    }

    @Test
    fun `a float target keeps what is beyond 0 and 1, and shows it clamped`() {
        for (samples in listOf(0, 4)) {
            RenderTarget(1, 1, samples, ColorFormat.RGBA32F).use { target ->
                clear(-3f, 1e20f, 0.1f)
                assertArrayEquals(floatArrayOf(-3f, 1e20f, 0.1f, 1f), target.readFloats().rgba)
                // 25.5 lies between two.
                val (r, g, b, a) = target.read().rgba.map { it.toInt() and 0xFF }
                assertEquals(listOf(0, 255, 255), listOf(r, g, a))
                assertTrue(b in 25..26, "$b")
            }
        }
    }

    @Test
    fun `after reading it is still drawn into`() {
        RenderTarget(1, 1, 4).use { target ->
            clear(1f, 0f, 0f)
            target.read()
            clear(0f, 1f, 0f)
            assertEquals(listOf(0, 255, 0, 255), target.read().rgba.map { it.toInt() and 0xFF })
        }
    }

    @Test
    fun `sizes and samples beyond the driver's are named with its limits`() {
        val side = glGetInteger(GL_MAX_RENDERBUFFER_SIZE)
        for ((width, height) in listOf(0 to 1, 1 to 0, -1 to 5, side + 1 to 1, 1 to side + 1, Int.MAX_VALUE to Int.MAX_VALUE)) {
            assertRefused("${width}x$height", "${side}x$side") { RenderTarget(width, height) }
        }
        val most = glGetInteger(GL_MAX_SAMPLES)
        for (samples in listOf(-1, most + 1, Int.MAX_VALUE)) assertRefused("$samples samples", "0 to $most") { RenderTarget(1, 1, samples) }
    }

    @Test
    fun `sizes and samples up to the driver's are taken`() {
        val side = glGetInteger(GL_MAX_RENDERBUFFER_SIZE)
        for ((width, height) in listOf(1 to side, side to 1)) RenderTarget(width, height).use { assertEquals(width, it.read().width) }
        for (samples in 0..glGetInteger(GL_MAX_SAMPLES)) RenderTarget(1, 1, samples).close()
        GLError.check("making the largest targets")
    }

    private fun clear(
        red: Float,
        green: Float,
        blue: Float,
    ) {
        glClearColor(red, green, blue, 1f)
        glClear(GL_COLOR_BUFFER_BIT)
    }

    private fun assertRefused(
        value: String,
        limit: String,
        action: () -> RenderTarget,
    ) {
        val message = assertThrows<InputError>(value) { action() }.message.orEmpty()
        assertTrue(value in message && limit in message, message)
        GLError.check("refusing $value")
    }
}

package cga.framework

import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*

@ExtendWith(Offscreen::class)
class GLErrorTest {
    @Test
    fun `an error is named with what was being done, once`() {
        GLError.check("doing nothing")
        glEnable(-1)
        val message = assertThrows<IllegalStateException> { GLError.check("enabling nothing") }.message
        assertEquals("OpenGL reported GL_INVALID_ENUM while enabling nothing.", message)
        GLError.check("doing nothing")
    }
}

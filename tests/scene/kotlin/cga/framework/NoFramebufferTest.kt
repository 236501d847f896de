package cga.framework

import cga.testing.CgaProcess
import cga.testing.OnXvfb
import cga.testing.Xvfb
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.glfw.GLFW.glfwGetCurrentContext
import org.lwjgl.glfw.GLFW.glfwSetFramebufferSizeCallback
import java.nio.file.Path

/** On Windows a minimised window has a framebuffer of size 0; here GLFW's own callback is made to say so. */
@ExtendWith(OnXvfb::class)
class NoFramebufferTest(private val display: Xvfb) {
    @Test
    fun `a framebuffer of size 0 leaves the last size, so that no aspect ratio divides by 0`(
        @TempDir directory: Path,
    ) {
        val process = CgaProcess.java("cga.framework.NoFramebufferTest", emptyList(), directory, env = display.variables)
        assertEquals(0, process.exitCode, "$process")
        assertEquals("320x200 at 1.0\n".repeat(3), process.out, "$process")
    }

    private class Shrunk : GameWindow(320, 200, false, false, 3, 3, "Shrunk", 0, 120) {
        override fun render(
            dt: Float,
            t: Float,
        ) {
            val callback = glfwSetFramebufferSizeCallback(glfwGetCurrentContext(), null) ?: error("no callback")
            for ((width, height) in listOf(0 to 0, 0 to 200, 320 to 0)) {
                callback.invoke(glfwGetCurrentContext(), width, height)
                println("${framebufferWidth}x$framebufferHeight at $pixelRatio")
            }
            GLError.check("drawing nothing")
            quit()
        }
    }

    companion object {
        @JvmStatic
        fun main(args: Array<String>) = Shrunk().run()
    }
}

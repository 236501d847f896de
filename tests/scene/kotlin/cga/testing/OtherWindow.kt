package cga.testing

import org.lwjgl.glfw.GLFW.*
import org.lwjgl.system.MemoryUtil.NULL
import java.nio.file.Path

/** A window of another program: [start] opens it on a display, and it has the keyboard then. */
class OtherWindow private constructor(private val process: Process) : AutoCloseable {
    override fun close() {
        process.destroyForcibly().waitFor()
    }

    companion object {
        private const val TITLE = "another window"

        fun start(display: Xvfb): OtherWindow {
            val builder = ProcessBuilder(CgaProcess.command("cga.testing.OtherWindow", emptyList(), Path.of("")))
            builder.environment() += display.variables
            val window = OtherWindow(builder.start())
            check(window.process.inputReader().readLine() == TITLE) { "the other window did not open" }
            return window
        }

        @JvmStatic
        fun main(args: Array<String>) {
            check(glfwInit())
            glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API)
            val window = glfwCreateWindow(200, 100, TITLE, NULL, NULL)
            while (glfwGetWindowAttrib(window, GLFW_FOCUSED) == GLFW_FALSE) glfwWaitEventsTimeout(0.02)
            println(TITLE)
            while (!glfwWindowShouldClose(window)) glfwWaitEvents()
        }
    }
}

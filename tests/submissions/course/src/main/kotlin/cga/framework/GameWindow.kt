package cga.framework

import org.lwjgl.glfw.Callbacks.glfwFreeCallbacks
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.glfw.GLFWErrorCallback
import org.lwjgl.opengl.GL
import org.lwjgl.opengl.GL11.GL_TRUE
import org.lwjgl.opengl.GL11.glViewport
import org.lwjgl.system.MemoryUtil.NULL

class MousePosition(var xpos: Double, var ypos: Double)

/** Opens a window with an OpenGL context and runs the game loop in it. */
abstract class GameWindow(
    val windowWidth: Int,
    val windowHeight: Int,
    private val fullscreen: Boolean,
    private val vsync: Boolean,
    private val cvmaj: Int,
    private val cvmin: Int,
    private val title: String,
    private val msaasamples: Int,
    private val updatefrequency: Float
) {
    var m_window: Long = NULL
        private set
    var framebufferWidth = windowWidth
        private set
    var framebufferHeight = windowHeight
        private set

    val mousePos = MousePosition(0.0, 0.0)

    protected abstract fun start()
    protected abstract fun update(dt: Float, t: Float)
    protected abstract fun render(dt: Float, t: Float)
    protected open fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}
    protected open fun onMouseMove(xpos: Double, ypos: Double) {}
    protected open fun onMouseButton(button: Int, action: Int, mode: Int) {}
    protected open fun onMouseScroll(xoffset: Double, yoffset: Double) {}
    protected open fun shutdown() {}

    fun getKeyState(key: Int): Boolean = glfwGetKey(m_window, key) == GLFW_PRESS

    fun setCursorVisible(visible: Boolean) {
        glfwSetInputMode(m_window, GLFW_CURSOR, if (visible) GLFW_CURSOR_NORMAL else GLFW_CURSOR_DISABLED)
    }

    fun quit() {
        glfwSetWindowShouldClose(m_window, true)
    }

    fun run() {
        openWindow()
        start()
        gameLoop()
        shutdown()
        glfwFreeCallbacks(m_window)
        glfwDestroyWindow(m_window)
        glfwTerminate()
    }

    private fun openWindow() {
        GLFWErrorCallback.createPrint(System.err).set()
        check(glfwInit()) { "GLFW could not be initialised" }
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, cvmaj)
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, cvmin)
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE)
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GL_TRUE)
        glfwWindowHint(GLFW_SAMPLES, msaasamples)
        val monitor = if (fullscreen) glfwGetPrimaryMonitor() else NULL
        m_window = glfwCreateWindow(windowWidth, windowHeight, title, monitor, NULL)
        check(m_window != NULL) { "the window could not be created" }

        glfwSetKeyCallback(m_window) { _, key, scancode, action, mode -> onKey(key, scancode, action, mode) }
        glfwSetMouseButtonCallback(m_window) { _, button, action, mode -> onMouseButton(button, action, mode) }
        glfwSetScrollCallback(m_window) { _, x, y -> onMouseScroll(x, y) }
        glfwSetCursorPosCallback(m_window) { _, x, y ->
            mousePos.xpos = x
            mousePos.ypos = y
            onMouseMove(x, y)
        }
        glfwSetFramebufferSizeCallback(m_window) { _, width, height ->
            framebufferWidth = width
            framebufferHeight = height
            glViewport(0, 0, width, height)
        }

        glfwMakeContextCurrent(m_window)
        glfwSwapInterval(if (vsync) 1 else 0)
        GL.createCapabilities()
    }

    private fun gameLoop() {
        val step = 1.0 / updatefrequency
        var updated = 0.0
        var last = glfwGetTime()
        val begin = last
        while (!glfwWindowShouldClose(m_window)) {
            glfwPollEvents()
            val now = glfwGetTime()
            while (updated + step <= now - begin) {
                updated += step
                update(step.toFloat(), updated.toFloat())
            }
            render((now - last).toFloat(), (now - begin).toFloat())
            last = now
            glfwSwapBuffers(m_window)
        }
    }
}

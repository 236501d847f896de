package cga.framework

import cga.grading.worker.Stage
import org.lwjgl.glfw.GLFW

/**
 * The grader's stand-in for the course's class of this name, with the same members: off screen, and played by a script.
 *
 * Plain Kotlin of the oldest kind, since the compiler that the submission names compiles it.
 */
abstract class GameWindow(
    width: Int,
    height: Int,
    val fullscreen: Boolean,
    val vsync: Boolean,
    val cvmaj: Int,
    val cvmin: Int,
    val title: String,
    val msaasamples: Int,
    val updatefrequency: Float
) {
    constructor(
        width: Int,
        height: Int,
        fullscreen: Boolean,
        vsync: Boolean,
        cvmaj: Int,
        cvmin: Int,
        title: String,
        msaasamples: Int,
        updatefrequency: Int
    ) : this(width, height, fullscreen, vsync, cvmaj, cvmin, title, msaasamples, updatefrequency.toFloat())

    class MousePosition(var xpos: Double, var ypos: Double)

    private val stage = Stage(width, height, title, cvmaj, cvmin, msaasamples, updatefrequency.toDouble())
    private val mouse = MousePosition(stage.cursorX, stage.cursorY)

    /** The real handle of a real, invisible window. */
    var m_window: Long = stage.window

    var windowWidth: Int = width
        protected set
    var windowHeight: Int = height
        protected set
    var framebufferWidth: Int = width
        protected set
    var framebufferHeight: Int = height
        protected set

    val currentTime: Double
        get() = stage.time

    val mousePos: MousePosition
        get() = MousePosition(stage.cursorX, stage.cursorY)

    protected open fun start() {}

    protected open fun update(dt: Float, t: Float) {}

    protected open fun render(dt: Float, t: Float) {}

    protected open fun onMouseMove(xpos: Double, ypos: Double) {}

    protected open fun onMouseButton(button: Int, action: Int, mode: Int) {}

    protected open fun onMouseScroll(xoffset: Double, yoffset: Double) {}

    protected open fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    protected open fun onFramebufferSize(width: Int, height: Int) {}

    protected open fun onWindowSize(width: Int, height: Int) {}

    protected open fun shutdown() {}

    fun getKeyState(key: Int): Boolean = stage.isHeld(key)

    fun setCursorVisible(visible: Boolean) {
        GLFW.glfwSetInputMode(m_window, GLFW.GLFW_CURSOR, if (visible) GLFW.GLFW_CURSOR_NORMAL else GLFW.GLFW_CURSOR_DISABLED)
    }

    fun setTitle(text: String) {
        GLFW.glfwSetWindowTitle(m_window, text)
    }

    fun quit() {
        stage.quit()
    }

    fun run() {
        try {
            start()
            play()
            shutdown()
        } catch (e: Throwable) {
            stage.fail(e)
            throw e
        }
    }

    private fun play() {
        while (true) {
            when (stage.next()) {
                Stage.UPDATE -> update(stage.dt, stage.time.toFloat())
                Stage.RENDER -> render(stage.dt, stage.time.toFloat())
                Stage.KEY -> onKey(stage.key, GLFW.glfwGetKeyScancode(stage.key), stage.action, stage.modifiers)
                Stage.MOVE -> {
                    mouse.xpos = stage.cursorX
                    mouse.ypos = stage.cursorY
                    onMouseMove(stage.cursorX, stage.cursorY)
                }
                else -> return
            }
        }
    }
}

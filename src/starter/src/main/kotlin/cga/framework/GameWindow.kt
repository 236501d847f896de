package cga.framework

import cga.coach.Program
import cga.coach.Stage

/** The mouse cursor in screen coordinates, from the upper left corner. */
class MousePosition(var xpos: Double, var ypos: Double)

/**
 * A window with an OpenGL context and a game loop: [update] at a fixed rate, [render] once a picture. All times are in seconds.
 *
 * The window itself is in libs/cga-coach.jar. It takes saved shaders and compiled classes while it runs.
 */
abstract class GameWindow(
    width: Int,
    height: Int,
    fullscreen: Boolean,
    vsync: Boolean,
    cvmaj: Int,
    cvmin: Int,
    title: String,
    msaasamples: Int,
    updatefrequency: Float
) {
    private val stage = Stage(width, height, fullscreen, vsync, cvmaj, cvmin, title, msaasamples, updatefrequency)
    private val mouse = MousePosition(stage.mouseX, stage.mouseY)

    /** Size of the picture in pixels. */
    val framebufferWidth: Int get() = stage.framebufferWidth
    val framebufferHeight: Int get() = stage.framebufferHeight

    /** GLFW's handle of the window. */
    val m_window: Long get() = stage.window

    /** Time of the last update. */
    val currentTime: Double get() = stage.time

    val mousePos: MousePosition
        get() {
            mouse.xpos = stage.mouseX
            mouse.ypos = stage.mouseY
            return mouse
        }

    protected abstract fun start()
    protected abstract fun update(dt: Float, t: Float)
    protected abstract fun render(dt: Float, t: Float)
    protected open fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}
    protected open fun onMouseMove(xpos: Double, ypos: Double) {}
    protected open fun onMouseButton(button: Int, action: Int, mode: Int) {}
    protected open fun onMouseScroll(xoffset: Double, yoffset: Double) {}
    protected open fun shutdown() {}

    /** Whether [key], a GLFW_KEY_… constant, is held down. */
    fun getKeyState(key: Int): Boolean = stage.isDown(key)

    fun setCursorVisible(visible: Boolean) = stage.setCursorVisible(visible)

    fun quit() = stage.quit()

    /** Plays until the window is closed. */
    fun run() = stage.run(Game())

    private inner class Game : Program {
        override fun start() = this@GameWindow.start()
        override fun update(dt: Float, t: Float) = this@GameWindow.update(dt, t)
        override fun render(dt: Float, t: Float) = this@GameWindow.render(dt, t)
        override fun onKey(key: Int, scancode: Int, action: Int, mode: Int) = this@GameWindow.onKey(key, scancode, action, mode)
        override fun onMouseMove(xpos: Double, ypos: Double) = this@GameWindow.onMouseMove(xpos, ypos)
        override fun onMouseButton(button: Int, action: Int, mode: Int) = this@GameWindow.onMouseButton(button, action, mode)
        override fun onMouseScroll(xoffset: Double, yoffset: Double) = this@GameWindow.onMouseScroll(xoffset, yoffset)
        override fun shutdown() = this@GameWindow.shutdown()
    }
}

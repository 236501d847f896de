package cga.exercise.game

import cga.framework.GameWindow
import org.lwjgl.glfw.GLFW.GLFW_KEY_ESCAPE
import org.lwjgl.glfw.GLFW.GLFW_PRESS

class Game(
    width: Int,
    height: Int,
    fullscreen: Boolean = false,
    vsync: Boolean = false,
    title: String = "Tron",
    glVersionMajor: Int = 3,
    glVersionMinor: Int = 3
) : GameWindow(width, height, fullscreen, vsync, glVersionMajor, glVersionMinor, title, 4, 120.0f) {

    private lateinit var scene: Scene

    override fun start() {
        scene = Scene(this)
        setCursorVisible(false)
    }

    override fun update(dt: Float, t: Float) = scene.update(dt, t)

    override fun render(dt: Float, t: Float) = scene.render(dt, t)

    override fun onMouseMove(xpos: Double, ypos: Double) = scene.onMouseMove(xpos, ypos)

    override fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_ESCAPE && action == GLFW_PRESS) quit()
        scene.onKey(key, scancode, action, mode)
    }

    override fun shutdown() = scene.cleanup()
}

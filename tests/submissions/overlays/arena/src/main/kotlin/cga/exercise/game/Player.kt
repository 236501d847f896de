package cga.exercise.game

import cga.exercise.components.geometry.Renderable
import cga.framework.GameWindow
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import kotlin.math.abs

class Player(val model: Renderable) {
    var speed = 0.0f
        private set
    var energy = 1.0f
        private set

    fun update(window: GameWindow, dt: Float, obstacles: List<Obstacle>) {
        when {
            window.getKeyState(GLFW_KEY_W) -> speed = minOf(speed + 12.0f * dt, MAX_SPEED)
            window.getKeyState(GLFW_KEY_S) -> speed = maxOf(speed - 12.0f * dt, -3.0f)
            else -> speed *= maxOf(0.0f, 1.0f - 5.0f * dt)
        }
        if (abs(speed) < 0.05f) speed = 0.0f
        if (speed == 0.0f) return

        val before = model.getLocalModelMatrix()
        if (window.getKeyState(GLFW_KEY_A)) model.rotateLocal(0.0f, 0.25f * speed * dt, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) model.rotateLocal(0.0f, -0.25f * speed * dt, 0.0f)
        model.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))

        val p = model.getWorldPosition()
        if (abs(p.x) > 21.0f || abs(p.z) > 21.0f || obstacles.any { it.hits(p) }) {
            model.modelMatrix = before
            speed *= -0.4f
            energy = maxOf(0.0f, energy - 0.1f)
        }
    }

    companion object {
        const val MAX_SPEED = 8.0f
    }
}

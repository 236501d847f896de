package cga.exercise.game

import cga.exercise.components.geometry.Shapes
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL11.*
import kotlin.math.abs

/** The speedometer at the lower left. */
class Hud {
    private val shader = ShaderProgram("assets/shaders/hud_vert.glsl", "assets/shaders/hud_frag.glsl")
    private val square = Shapes.square()

    fun render(speed: Float) {
        glDisable(GL_DEPTH_TEST)
        shader.use()
        bar(Vector2f(0.5f, 0.03f), Vector3f(0.08f))
        bar(Vector2f(0.5f * abs(speed) / Driver.TOP_SPEED, 0.03f), Vector3f(0.9f, 0.6f, 0.1f))
        glEnable(GL_DEPTH_TEST)
    }

    private fun bar(size: Vector2f, color: Vector3f) {
        shader.setUniform("offset", Vector2f(-0.95f, -0.93f))
        shader.setUniform("size", size)
        shader.setUniform("barColor", color)
        square.render()
    }

    fun cleanup() {
        square.cleanup()
        shader.cleanup()
    }
}

package cga.exercise.components.effects

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL11.*

/** Tacho und Energieanzeige, als Rechtecke über dem fertigen Bild. */
class Hud {
    private val shader = ShaderProgram("assets/shaders/hud_vert.glsl", "assets/shaders/hud_frag.glsl")
    private val quad = Mesh(
        floatArrayOf(0f, 0f, 1f, 0f, 1f, 1f, 0f, 1f),
        intArrayOf(0, 1, 2, 0, 2, 3),
        arrayOf(VertexAttribute(2, 8, 0))
    )

    fun render(speed: Float, energy: Float) {
        glDisable(GL_DEPTH_TEST)
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        shader.use()
        bar(-0.96f, 0.76f, 0.44f, 0.2f, Vector3f(0.1f, 0.1f, 0.15f), 0.5f)
        bar(-0.94f, 0.88f, 0.02f + 0.38f * speed, 0.05f, Vector3f(0.1f, 0.8f, 1.0f), 0.8f)
        bar(-0.94f, 0.79f, 0.4f * energy, 0.05f, Vector3f(1.0f, 0.6f, 0.1f), 0.8f)
        glDisable(GL_BLEND)
        glEnable(GL_DEPTH_TEST)
    }

    private fun bar(x: Float, y: Float, w: Float, h: Float, color: Vector3f, alpha: Float) {
        shader.setUniform("ecke", Vector2f(x, y))
        shader.setUniform("groesse", Vector2f(w, h))
        shader.setUniform("farbe", color)
        shader.setUniform("alpha", alpha)
        quad.render()
    }

    fun cleanup() {
        quad.cleanup()
        shader.cleanup()
    }
}

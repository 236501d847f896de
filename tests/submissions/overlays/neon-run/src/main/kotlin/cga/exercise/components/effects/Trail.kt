package cga.exercise.components.effects

import cga.exercise.components.camera.ICamera
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f
import org.lwjgl.opengl.GL30.*

/** The ribbon of light behind the motorcycle. */
class Trail(private val owner: Transformable) {
    private val shader = ShaderProgram("assets/shaders/trail_vert.glsl", "assets/shaders/trail_frag.glsl")
    private val points = ArrayDeque<Vector3f>()
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, LENGTH * 2L * 4L * 4L, GL_DYNAMIC_DRAW)
        glEnableVertexAttribArray(0)
        glVertexAttribPointer(0, 4, GL_FLOAT, false, 16, 0)
        glBindVertexArray(0)
    }

    fun update() {
        val tail = owner.getWorldModelMatrix().transformPosition(Vector3f(0.0f, 0.0f, 1.9f))
        if (points.isEmpty() || points.last().distance(tail) > 0.2f) points.addLast(tail)
        if (points.size > LENGTH) points.removeFirst()
    }

    fun render(camera: ICamera, color: Vector3f) {
        if (points.size < 2) return
        val data = FloatArray(points.size * 8)
        for ((i, p) in points.withIndex()) {
            val age = i.toFloat() / points.size
            data[8 * i] = p.x
            data[8 * i + 1] = 0.05f
            data[8 * i + 2] = p.z
            data[8 * i + 3] = age
            data[8 * i + 4] = p.x
            data[8 * i + 5] = 0.6f
            data[8 * i + 6] = p.z
            data[8 * i + 7] = age
        }
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferSubData(GL_ARRAY_BUFFER, 0, data)

        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE)
        glDepthMask(false)
        glDisable(GL_CULL_FACE)
        shader.use()
        camera.bind(shader)
        shader.setUniform("trailColor", color)
        glBindVertexArray(vao)
        glDrawArrays(GL_TRIANGLE_STRIP, 0, points.size * 2)
        glBindVertexArray(0)
        glEnable(GL_CULL_FACE)
        glDepthMask(true)
        glDisable(GL_BLEND)
    }

    fun cleanup() {
        glDeleteBuffers(vbo)
        glDeleteVertexArrays(vao)
        shader.cleanup()
    }

    companion object {
        private const val LENGTH = 60
    }
}

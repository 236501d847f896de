package cga.exercise.components.framebuffer

import cga.exercise.components.shader.ShaderProgram
import org.lwjgl.opengl.GL30.*

/** Ein Rechteck ueber den ganzen Bildschirm, auf das die fertige Szene geklebt wird. */
class ScreenQuad {
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()

    private val vertices = floatArrayOf(
        // Position    Textur
        -1.0f, 1.0f, 0.0f, 1.0f,
        -1.0f, -1.0f, 0.0f, 0.0f,
        1.0f, -1.0f, 1.0f, 0.0f,
        -1.0f, 1.0f, 0.0f, 1.0f,
        1.0f, -1.0f, 1.0f, 0.0f,
        1.0f, 1.0f, 1.0f, 1.0f
    )

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, vertices, GL_STATIC_DRAW)
        glEnableVertexAttribArray(0)
        glVertexAttribPointer(0, 2, GL_FLOAT, false, 16, 0)
        glEnableVertexAttribArray(1)
        glVertexAttribPointer(1, 2, GL_FLOAT, false, 16, 8)
        glBindVertexArray(0)
    }

    fun render(shader: ShaderProgram, scene: Framebuffer, effect: Int) {
        glDisable(GL_DEPTH_TEST)
        shader.use()
        scene.bindTexture(0)
        shader.setUniform("screenTexture", 0)
        shader.setUniform("effect", effect)
        glBindVertexArray(vao)
        glDrawArrays(GL_TRIANGLES, 0, 6)
        glBindVertexArray(0)
        glEnable(GL_DEPTH_TEST)
    }

    fun cleanup() {
        glDeleteBuffers(vbo)
        glDeleteVertexArrays(vao)
    }
}

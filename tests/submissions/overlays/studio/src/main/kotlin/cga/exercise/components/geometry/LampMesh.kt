package cga.exercise.components.geometry

import org.lwjgl.opengl.GL31.*

/** An octahedron that is drawn once for each lamp. */
class LampMesh {
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()
    private val ibo = glGenBuffers()
    private val indices = intArrayOf(0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5)

    init {
        val corners = floatArrayOf(1f, 0f, 0f, -1f, 0f, 0f, 0f, 0f, -1f, 0f, 0f, 1f, 0f, 1f, 0f, 0f, -1f, 0f)
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, corners, GL_STATIC_DRAW)
        glEnableVertexAttribArray(0)
        glVertexAttribPointer(0, 3, GL_FLOAT, false, 12, 0L)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, ibo)
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, indices, GL_STATIC_DRAW)
        glBindVertexArray(0)
    }

    fun render(times: Int) {
        glBindVertexArray(vao)
        glDrawElementsInstanced(GL_TRIANGLES, indices.size, GL_UNSIGNED_INT, 0L, times)
        glBindVertexArray(0)
    }

    fun cleanup() {
        glDeleteBuffers(ibo)
        glDeleteBuffers(vbo)
        glDeleteVertexArrays(vao)
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.lwjgl.opengl.GL30.*

class Mesh(
    vertexdata: FloatArray,
    indexdata: IntArray,
    attributes: Array<VertexAttribute>,
    private val material: Material? = null
) {
    private val indexcount = indexdata.size
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()
    private val ibo = glGenBuffers()

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, vertexdata, GL_STATIC_DRAW)
        for ((i, attribute) in attributes.withIndex()) {
            glEnableVertexAttribArray(i)
            glVertexAttribPointer(i, attribute.n, GL_FLOAT, false, attribute.stride, attribute.offset.toLong())
        }
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, ibo)
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, indexdata, GL_STATIC_DRAW)
        glBindVertexArray(0)
    }

    fun render() {
        glBindVertexArray(vao)
        glDrawElements(GL_TRIANGLES, indexcount, GL_UNSIGNED_INT, 0)
        glBindVertexArray(0)
    }

    fun render(shaderProgram: ShaderProgram) {
        material?.bind(shaderProgram)
        render()
    }

    fun cleanup() {
        glDeleteBuffers(ibo)
        glDeleteBuffers(vbo)
        glDeleteVertexArrays(vao)
    }
}

package cga.exercise.components.geometry

import org.lwjgl.opengl.GL30.*

class Mesh(vertices: FloatArray, indices: IntArray, attributes: Array<VertexAttribute>, val material: Material) {
    val vao = glGenVertexArrays()
    val count = indices.size

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, glGenBuffers())
        glBufferData(GL_ARRAY_BUFFER, vertices, GL_STATIC_DRAW)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, glGenBuffers())
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, indices, GL_STATIC_DRAW)
        for (i in attributes.indices) {
            glVertexAttribPointer(i, attributes[i].n, GL_FLOAT, false, attributes[i].stride, attributes[i].offset.toLong())
            glEnableVertexAttribArray(i)
        }
        glBindVertexArray(0)
    }
}

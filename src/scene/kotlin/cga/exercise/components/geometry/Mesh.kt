package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.lwjgl.opengl.GL33C.*

/**
 * Triangles on the GPU; uploaded when first rendered, so a mesh can be made without a context.
 *
 * @param vertexdata the vertices, laid out as [attributes] say; not copied, not to be changed.
 * @param indexdata three indices a triangle; likewise.
 * @param attributes attribute i feeds the shader's input at location i.
 * @param material what the surface looks like, or null to leave the shader's material alone.
 */
public class Mesh(
    public val vertexdata: FloatArray,
    public val indexdata: IntArray,
    private val attributes: Array<VertexAttribute>,
    public val material: Material? = null,
) {
    private var vao = 0
    private var vbo = 0
    private var ibo = 0

    /** Draws the triangles with the program in use. */
    public fun render() {
        if (vao == 0) upload()
        glBindVertexArray(vao)
        glDrawElements(GL_TRIANGLES, indexdata.size, GL_UNSIGNED_INT, 0L)
    }

    /** Sends the material to [shaderProgram] and draws the triangles. */
    public fun render(shaderProgram: ShaderProgram) {
        material?.bind(shaderProgram)
        render()
    }

    /** Frees the GPU's copy; rendering again uploads again. */
    public fun cleanup() {
        if (vao == 0) return
        glDeleteVertexArrays(vao)
        glDeleteBuffers(vbo)
        glDeleteBuffers(ibo)
        vao = 0
    }

    private fun upload() {
        vao = glGenVertexArrays()
        glBindVertexArray(vao)
        vbo = glGenBuffers()
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, vertexdata, GL_STATIC_DRAW)
        attributes.forEachIndexed { location, attribute ->
            glEnableVertexAttribArray(location)
            glVertexAttribPointer(location, attribute.n, GL_FLOAT, false, attribute.stride, attribute.offset.toLong())
        }
        ibo = glGenBuffers()
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, ibo)
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, indexdata, GL_STATIC_DRAW)
        glBindVertexArray(0)
    }
}

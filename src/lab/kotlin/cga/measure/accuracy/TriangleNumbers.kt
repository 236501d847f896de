package cga.measure.accuracy

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.shader.ShaderProgram
import cga.framework.Frame
import cga.reference.ReferencePicture
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.lwjgl.opengl.GL33C.*
import kotlin.io.path.createTempFile
import kotlin.io.path.deleteIfExists
import kotlin.io.path.writeText

/** Which triangle OpenGL shows in each pixel, numbered as [ReferencePicture.surface]. */
internal object TriangleNumbers {
    /** Position, texture coordinates, normal: eight floats a vertex. */
    private val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    /** Draws [frame] into the bound float target, with the number of its triangle as the red of each pixel. */
    fun draw(frame: Frame) {
        val program = program()
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)
        glClearColor(ReferencePicture.NO_SURFACE.toFloat(), 0f, 0f, 0f)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        program.use()
        program.setUniform("projection", frame.projection, false)
        var first = 0
        for (draw in frame.draws) {
            program.setUniform("modelView", Matrix4f(frame.view.mul(draw.model, Matrix4d())), false)
            program.setUniform("first", first)
            Mesh(draw.vertices, draw.indices, attributes).apply { render() }.cleanup()
            first += draw.indices.size / 3
        }
        program.cleanup()
    }

    private fun program(): ShaderProgram {
        val fragment = createTempFile("cga-numbers", ".frag")
        try {
            fragment.writeText(
                "#version 330 core\nuniform int first;\nout vec4 color;\nvoid main() { color = vec4(first + gl_PrimitiveID); }\n",
            )
            return ShaderProgram("shaders/scene.vert", "$fragment")
        } finally {
            fragment.deleteIfExists()
        }
    }
}

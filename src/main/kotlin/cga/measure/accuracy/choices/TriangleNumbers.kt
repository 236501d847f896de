package cga.measure.accuracy.choices

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.shader.ShaderProgram
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.FloatImage
import cga.reference.ReferencePicture
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.lwjgl.opengl.GL33C.*

/** Which triangle OpenGL shows in each pixel, in the red channel, numbered as the reference does. */
internal object TriangleNumbers {
    /** Position, texture coordinates, normal: eight floats a vertex. */
    private val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    private val edit =
        ShaderEdit(
            EditedHome.FRAGMENT,
            "void main() {\n",
            "uniform int first;\nvoid main() {\n    fragColor = vec4(first + gl_PrimitiveID);\n    return;\n",
        )

    fun draw(
        size: PictureSize,
        home: EditedHome,
    ): FloatImage {
        val program = home.with(listOf(edit)) { ShaderProgram("shaders/${EditedHome.VERTEX}", "shaders/${EditedHome.FRAGMENT}") }
        val frame = scene(size).scene.frame()
        RenderTarget(size.width, size.height, 0, ColorFormat.RGBA32F).use { target ->
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
            return target.readFloats()
        }
    }
}

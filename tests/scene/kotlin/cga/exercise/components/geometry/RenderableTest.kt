package cga.exercise.components.geometry

import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.RecordingProgram
import cga.testing.assertNear
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

class RenderableTest {
    @Test
    fun `it sends where it is seen and how its normals lie`() {
        val parent = Transformable(Matrix4f().translation(0f, 0f, -10f))
        val renderable = Renderable(emptyList(), Matrix4f().scaling(1f, 2f, 1f), parent)
        val program = RecordingProgram()
        renderable.render(program, Matrix4d().translation(0.0, 0.0, 5.0))
        val expected = mapOf("modelView" to Matrix4f().translation(0f, 0f, -5f).scale(1f, 2f, 1f), "normalMatrix" to normals())
        assertEquals(expected, program.sent)
    }

    private fun normals() = Matrix3f().scaling(1f, 0.5f, 1f)

    @Test
    fun `far from the origin it loses nothing`() {
        val far = Transformable(Matrix4f().translation(1e6f, 0f, 1e6f))
        val renderable = Renderable(emptyList(), Matrix4f().translation(0.001f, 0f, -4f), far)
        val program = RecordingProgram()
        renderable.render(program, Matrix4d().translation(-1e6, 0.0, -1e6))
        // Rounding of the float 0.001 and of the result; in floats the 1e6 would have swallowed it: their ulp is 0.06.
        val position = (program.sent.getValue("modelView") as Matrix4f).getTranslation(Vector3f())
        assertNear(0.001, position.x, 1e-3 * 2 * FLOAT_ROUNDING + 1e6 * 4 * DOUBLE_ROUNDING)
    }

    @Test
    fun `meshes without a material are no part of a frame`() {
        val bare = Renderable(listOf(Mesh(FloatArray(8), IntArray(3), emptyArray())))
        val error = assertThrows<IllegalStateException> { bare.toFrameDraws(Vector3f(1f)) }
        assertTrue("material" in error.message.orEmpty())
    }
}

package cga.grading.study

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.random.Random

class ViewProjectionTest {
    private val random = Random(21)

    private fun perspective() =
        Matrix4d().perspective(random.nextDouble(0.6, 2.0), random.nextDouble(0.7, 2.0), random.nextDouble(0.05, 0.5), 100.0)

    private fun rigid() =
        Matrix4d()
            .rotateXYZ(random.nextDouble(-3.0, 3.0), random.nextDouble(-3.0, 3.0), random.nextDouble(-3.0, 3.0))
            .translate(random.nextDouble(-20.0, 20.0), random.nextDouble(-5.0, 5.0), random.nextDouble(-20.0, 20.0))

    private fun floats(m: Matrix4dc) = m.get(FloatArray(16))

    private fun rounded(m: Matrix4dc) = GeometryFormula.matrix(floats(m))

    /**
     * Numbers of up to 30 are rounded by 2⁻²⁴ of themselves, 2e-6; dividing by the least factor of a projection (0.3) makes 6e-6 of that, and
     * what is left of the depths is a difference of two such.
     */
    private fun assertNear(
        expected: Matrix4dc,
        actual: Matrix4dc?,
    ) = assertTrue(actual?.equals(expected, 2e-5) == true) { "expected\n$expected\nbut was\n$actual" }

    @Test
    fun `any perspective and any view, also a stretched one, come apart again`() {
        repeat(200) {
            val projection = perspective()
            val view = Matrix4d().scaling(random.nextDouble(0.5, 1.5)).mul(rigid())
            val split = ViewProjection.of(rounded(projection.mul(view, Matrix4d())))
            assertNear(projection, split?.projection)
            assertNear(view, split?.view)
        }
    }

    @Test
    fun `what is no perspective, or goes through a matrix that is uneven, is none`() {
        assertNull(ViewProjection.of(Matrix4d().ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 100.0).mul(rigid())))
        assertNull(ViewProjection.of(perspective().mul(rigid().scale(1.0, 2.0, 1.0))))
        assertNull(ViewProjection.of(Matrix4d().zero()))
        assertNull(ViewProjection.of(Matrix4d()))
    }

    @Test
    fun `spaces of a draw that is sent projection and view as one`() {
        val (projection, view, model) = Triple(perspective(), rigid(), rigid().scale(0.8))
        val values = mapOf("vp" to floats(projection.mul(view, Matrix4d())), "m" to floats(model))
        val spaces = Spaces.of(GeometryFormula(0, listOf("vp", "m")), listOf("vp", "m"), values)
        assertNear(projection, spaces?.projection)
        assertNear(view, spaces?.view)
        assertEquals(rounded(model), spaces?.model)
    }

    @Test
    fun `spaces of a draw that is sent all three as one, and its model matrix beside`() {
        val (projection, view, model) = Triple(perspective(), rigid(), rigid().scale(0.8))
        val values = mapOf("mvp" to floats(projection.mul(view, Matrix4d()).mul(model)), "m" to floats(model))
        val spaces = Spaces.of(GeometryFormula(0, listOf("mvp")), listOf("mvp", "m"), values)
        // The view is found by the model matrix's inverse, which takes places some 30 units away back.
        val there = Vector3d(3.0, 1.0, -2.0)
        val seen = spaces?.view?.transformPosition(there, Vector3d())
        assertTrue(seen != null && seen.distance(view.transformPosition(there, Vector3d())) < 1e-4) { "$seen" }
        assertEquals(0.8, spaces?.modelView?.scale() ?: 0.0, 1e-5)
    }

    @Test
    fun `the way back that is sent for the normals is no view`() {
        val (projection, view, model) = Triple(perspective(), rigid(), rigid().scale(0.8))
        val modelView = view.mul(model, Matrix4d())
        val names = listOf("p", "mv", "n", "v")
        val values = names.zip(listOf(projection, modelView, modelView.invert(Matrix4d()), view).map(::floats)).toMap()
        val spaces = Spaces.of(GeometryFormula(0, listOf("p", "mv")), names, values)
        assertNear(view, spaces?.view)
        assertNear(model, spaces?.model)
    }
}

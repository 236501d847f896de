package cga.exercise.components.geometry

import cga.testing.FLOAT_ROUNDING
import cga.testing.assertNear
import cga.testing.turn
import org.joml.Matrix3d
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.pow
import kotlin.random.Random

class NormalMatrixTest {
    /** The largest element is 1, so rounding to floats moves none by more; the double arithmetic before is 1e-8 times finer. */
    private val rounded = FLOAT_ROUNDING

    @Test
    fun `nothing to do is nothing done`() {
        assertEquals(Matrix3f(), normalMatrix(Matrix3d()))
    }

    @Test
    fun `stretched along x, normals lean away from x`() {
        assertEquals(Matrix3f().scaling(0.5f, 1f, 1f), normalMatrix(Matrix3d().scaling(2.0, 1.0, 1.0)))
    }

    @Test
    fun `a move changes no normal`() {
        val matrix = Matrix4d().translation(5.0, 6.0, 7.0).rotateY(1.0)
        assertEquals(normalMatrix(matrix.get3x3(Matrix3d())), NormalMatrix().of(matrix, Matrix3f()))
    }

    @Test
    fun `it is the transposed inverse, up to its size`() {
        val random = Random(1)
        repeat(10_000) {
            val matrix = random.matrix { 10.0.pow(nextDouble(-2.0, 2.0)) }
            assertNear(transposedInverse(matrix), normalMatrix(matrix), rounded, "$matrix")
        }
    }

    @Test
    fun `mirrored models keep their outside`() {
        assertNear(Matrix3f().scaling(-1f, 1f, 1f), normalMatrix(Matrix3d().scaling(-1.0, 1.0, 1.0)), 0.0)
        val random = Random(2)
        repeat(1_000) {
            val matrix = random.matrix { 10.0.pow(nextDouble(-1.0, 1.0)) * if (nextBoolean()) -1 else 1 }
            assertNear(transposedInverse(matrix), normalMatrix(matrix), rounded, "$matrix")
        }
    }

    @Test
    fun `models of any size have the normals of the one of size 1`() {
        val rotation = turn(0.3, -1.1, 2.0)
        val expected = transposedInverse(rotation)
        for (exponent in -13..13) {
            assertNear(expected, normalMatrix(Matrix3d(rotation).scale(10.0.pow(exponent))), rounded, "1e$exponent")
        }
        val mixed = Matrix3d().scaling(1e-13, 1.0, 1e13)
        assertNear(transposedInverse(mixed), normalMatrix(mixed), rounded)
    }

    @Test
    fun `a flattened model has the normal of its plane`() {
        assertEquals(Matrix3f().scaling(0f, 1f, 0f), normalMatrix(Matrix3d().scaling(1.0, 0.0, 1.0)))
    }

    @Test
    fun `a model pressed to a line or a point has none, and no NaN`() {
        for (flat in listOf(Matrix3d().scaling(0.0, 0.0, 3.0), Matrix3d().zero())) {
            assertEquals(Matrix3f().zero(), normalMatrix(flat))
        }
    }

    @Test
    fun `normals stay perpendicular to the surface`() {
        val random = Random(3)
        repeat(10_000) {
            val matrix = random.matrix { 10.0.pow(nextDouble(-2.0, 2.0)) * if (nextBoolean()) -1 else 1 }
            val normal = random.direction()
            val tangent = random.direction().cross(normal)

            val turned = Matrix3d(normalMatrix(matrix)).transform(normal, Vector3d())
            val onSurface = matrix.transform(tangent, Vector3d())

            val cosine = turned.dot(onSurface) / (turned.length() * onSurface.length())
            // Nine elements, each off by half an ulp of at most 1, move the normal by at most √9 times that.
            val bound = 3 * FLOAT_ROUNDING / 2 / turned.length()
            assertTrue(abs(cosine) <= bound) { "cos = $cosine, more than $bound, with\n$matrix" }
        }
    }

    private fun normalMatrix(matrix: Matrix3d): Matrix3f = NormalMatrix().of(Matrix4d(matrix), Matrix3f())

    /** The textbook's, with the largest element made 1. */
    private fun transposedInverse(matrix: Matrix3d): Matrix3d {
        val inverse = matrix.invert(Matrix3d()).transpose()
        val largest = inverse.get(DoubleArray(9)).maxOf(::abs)
        for (column in 0..2) for (row in 0..2) inverse[column, row] = inverse[column, row] / largest
        return inverse
    }

    /** Turned, scaled along three axes, and turned again: every matrix is of that kind (its singular values are the scales). */
    private fun Random.matrix(scale: Random.() -> Double): Matrix3d =
        turn(nextDouble(6.0), nextDouble(6.0), nextDouble(6.0))
            .scale(scale(), scale(), scale())
            .mul(turn(nextDouble(6.0), nextDouble(6.0), nextDouble(6.0)))

    private fun Random.direction() = Vector3d(nextDouble(-1.0, 1.0), nextDouble(-1.0, 1.0), nextDouble(-1.0, 1.0)).normalize()
}

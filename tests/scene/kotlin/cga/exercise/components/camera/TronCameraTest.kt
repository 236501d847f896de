package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.RecordingProgram
import cga.testing.assertNear
import cga.testing.rows
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt
import kotlin.random.Random

class TronCameraTest {
    /** Cross products and square roots of unit vectors in double: a dozen roundings at most. */
    private val rigid = 16 * DOUBLE_ROUNDING

    @Test
    fun `it has the constants of the course`() {
        with(TronCamera()) {
            assertEquals(Math.toRadians(90.0).toFloat(), fieldOfView)
            assertEquals(16f / 9f, aspect)
            assertEquals(listOf(0.1f, 100f), listOf(near, far))
        }
    }

    @Test
    fun `without a parent the view undoes the camera's place`() {
        val camera = TronCamera().apply { translateLocal(Vector3f(1f, 2f, 5f)) }
        assertEquals(Matrix4f().translation(-1f, -2f, -5f), camera.getCalculateViewMatrix())
    }

    @Test
    fun `it looks along its own −z axis`() {
        for (camera in cameras()) {
            val view = camera.calculateViewMatrix(Matrix4d())
            val world = camera.getWorldModelMatrix(Matrix4d())
            val position = world.getTranslation(Vector3d())
            val ahead = world.transformDirection(Vector3d(0.0, 0.0, -1.0)).normalize(7.0).add(position)
            val tolerance = 16 * (position.length() + 7) * DOUBLE_ROUNDING
            assertNear(Vector3d(), view.transformPosition(position), tolerance)
            assertNear(Vector3d(0.0, 0.0, -7.0), view.transformPosition(ahead), tolerance)
        }
    }

    @Test
    fun `up is on the upper half of the picture`() {
        for (camera in cameras()) {
            val up = camera.getWorldModelMatrix(Matrix4d()).transformDirection(Vector3d(0.0, 1.0, 0.0)).normalize()
            val seen = camera.calculateViewMatrix(Matrix4d()).transformDirection(up)
            assertEquals(0.0, seen.x, rigid)
            assertTrue(seen.y > 0) { "$seen" }
        }
    }

    @Test
    fun `the view is rigid however the parents are scaled, sheared or mirrored`() {
        for (camera in cameras()) {
            val rotation = camera.calculateViewMatrix(Matrix4d()).get3x3(Matrix3d())
            assertNear(Matrix3d(), rotation.mulLocal(rotation.transpose(Matrix3d()), Matrix3d()), rigid)
            assertNear(1.0, rotation.determinant(), rigid)
        }
    }

    @Test
    fun `the float view is the double one, rounded`() {
        for (camera in cameras()) {
            assertEquals(Matrix4f(camera.calculateViewMatrix(Matrix4d())), camera.getCalculateViewMatrix())
        }
    }

    @Test
    fun `the projection is the perspective matrix`() {
        // tan 45° = 1: 9/16, 1, −(100 + 0.1)/(100 − 0.1), −2·100·0.1/(100 − 0.1).
        assertProjection(TronCamera(), 9.0 / 16, 1.0, -100.1 / 99.9, -20 / 99.9)
        // tan 30° = 1/√3: √3/2, √3, −(10 + 1)/(10 − 1), −2·10·1/(10 − 1).
        assertProjection(TronCamera((PI / 3).toFloat(), 2f, 1f, 10f), sqrt(3.0) / 2, sqrt(3.0), -11.0 / 9, -20.0 / 9)
    }

    @Test
    fun `its settings count from the next picture on`() {
        val camera = TronCamera().apply {
            aspect = 2f
            fieldOfView = (PI / 3).toFloat()
            near = 1f
            far = 10f
        }
        assertProjection(camera, sqrt(3.0) / 2, sqrt(3.0), -11.0 / 9, -20.0 / 9)
    }

    @Test
    fun `it sends the projection`() {
        val program = RecordingProgram()
        TronCamera().bind(program)
        assertEquals(mapOf("projection" to TronCamera().getCalculateProjectionMatrix()), program.sent)
    }

    @Test
    fun `getters make copies`() {
        val camera = TronCamera()
        camera.getCalculateProjectionMatrix().scaling(7f)
        camera.getCalculateViewMatrix().scaling(7f)
        assertNear(Matrix4f(), camera.getCalculateViewMatrix(), 0.0)
        assertProjection(camera, 9.0 / 16, 1.0, -100.1 / 99.9, -20 / 99.9)
    }

    private fun assertProjection(camera: TronCamera, m00: Double, m11: Double, m22: Double, m32: Double) {
        val expected = Matrix4d(m00, 0.0, 0.0, 0.0, 0.0, m11, 0.0, 0.0, 0.0, 0.0, m22, -1.0, 0.0, 0.0, m32, 0.0)
        // Angle, tangent, reciprocal, aspect; near, far, their sum and difference, and the quotient: at most six roundings of up to 2.3.
        assertNear(expected, camera.getCalculateProjectionMatrix(), 6 * 2.3 * FLOAT_ROUNDING)
    }

    /** Cameras under parents that scale, shear (by scaling what is turned) and mirror. */
    private fun cameras(): List<TronCamera> {
        val random = Random(1)

        fun number() = random.nextFloat() * 4 - 2
        val sheared = List(100) {
            val grandparent = Transformable().apply {
                translateGlobal(Vector3f(number(), number(), number()))
                scaleLocal(Vector3f(3 + number(), 3 + number(), -3 + number()))
            }
            val parent = Transformable(parent = grandparent).apply { rotateLocal(number(), number(), number()) }
            TronCamera(parent = parent).apply {
                rotateLocal(number(), number(), number())
                translateLocal(Vector3f(0f, 0f, 4f))
            }
        }
        val flat = TronCamera(parent = Transformable(rows(1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)))
        return sheared + flat + TronCamera(parent = Transformable(Matrix4f().scaling(0.8f)))
    }
}

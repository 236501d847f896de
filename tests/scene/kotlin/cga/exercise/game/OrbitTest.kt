package cga.exercise.game

import cga.testing.FLOAT_ROUNDING
import cga.testing.assertNear
import cga.testing.turn
import org.joml.Matrix3d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs

class OrbitTest {
    private val orbit = Orbit()

    @Test
    fun `the first event only says where the mouse is`() {
        orbit.onMouseMove(123_456.0, turning = true)
        assertEquals(0.0, orbit.angle)
    }

    @Test
    fun `a pixel to the right is 0,002 radians`() {
        orbit.onMouseMove(100.0, turning = true)
        orbit.onMouseMove(101.0, turning = true)
        assertEquals(0.002, orbit.angle)
        orbit.onMouseMove(99.0, turning = true)
        assertEquals(-0.002, orbit.angle)
    }

    @Test
    fun `while it does not turn, the mouse moves without effect`() {
        orbit.onMouseMove(0.0, turning = true)
        orbit.onMouseMove(500.0, turning = false)
        orbit.onMouseMove(501.0, turning = true)
        assertEquals(0.002, orbit.angle)
    }

    @Test
    fun `the angle never grows beyond a turn`() {
        orbit.onMouseMove(0.0, turning = true)
        for (sign in listOf(1, -1)) {
            for (event in 1..10) {
                orbit.onMouseMove(sign * event * 1e6, turning = true)
                assertTrue(abs(orbit.angle) < 2 * PI)
            }
        }
    }

    @Test
    fun `the camera stands 4 behind the motorcycle and looks down 35 degrees`() {
        orbit.onMouseMove(0.0, turning = true)
        for (pixels in 0..3_200) {
            orbit.onMouseMove(pixels.toDouble(), turning = true)
            val place = orbit.place(turned = true, Matrix4f())
            val rotation = turn(0.0, orbit.angle, 0.0).mul(turn(Math.toRadians(-35.0), 0.0, 0.0))
            // The angle, at most 2π, becomes a float; then four sines and cosines and their products do.
            val tolerance = (2 * PI + 4) * FLOAT_ROUNDING
            assertNear(rotation, place.get3x3(Matrix3d()), tolerance, "after $pixels pixels")
            assertNear(rotation.transform(Vector3d(0.0, 0.0, 4.0)), place.getTranslation(Vector3f()), 4 * tolerance, "after $pixels pixels")
        }
    }

    @Test
    fun `not turned it stands where it stood`() {
        val start = Orbit().place(turned = true, Matrix4f())
        orbit.onMouseMove(0.0, turning = true)
        orbit.onMouseMove(700.0, turning = true)
        assertEquals(start, orbit.place(turned = false, Matrix4f()))
    }
}

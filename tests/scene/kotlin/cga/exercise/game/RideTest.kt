package cga.exercise.game

import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.HeldKeys
import cga.testing.assertNear
import org.joml.Matrix3d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import org.lwjgl.glfw.GLFW.*
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sin

/** Driving: 4 units and 1.5 radians a second. */
class RideTest {
    private val ride = Ride()
    private val step = 1.0 / 120

    @Test
    fun `W drives straight ahead, S straight back`() {
        drive(10 * 120, GLFW_KEY_W)
        // 1,200 sums of up to 40.
        assertNear(-40.0, ride.z, 1_200 * 40 * DOUBLE_ROUNDING)
        assertEquals(0.0, ride.x)
        drive(15 * 120, GLFW_KEY_S)
        assertNear(20.0, ride.z, 3_000 * 40 * DOUBLE_ROUNDING)
        assertEquals(0.0, ride.heading)
    }

    @Test
    fun `a million frames ahead are a line of their length`() {
        drive(1_000_000, GLFW_KEY_W)
        val length = 4e6 / 120
        assertNear(-length, ride.z, 1e6 * length * DOUBLE_ROUNDING)
        assertEquals(0.0, ride.x)
        assertPlaced()
    }

    @Test
    fun `after a million frames of circling it is still upright, of its size, and looks where it drives`() {
        for (steering in listOf(GLFW_KEY_A, GLFW_KEY_D)) {
            drive(1_000_000, GLFW_KEY_W, steering)
            assertPlaced()
            val (x, z) = ride.x to ride.z
            drive(1, GLFW_KEY_W, steering)
            val ahead = Vector3d(ride.x - x, 0.0, ride.z - z).normalize()
            val looking = matrix().get3x3(Matrix3d()).transform(Vector3d(0.0, 0.0, -1 / 0.8))
            // The heading of at most a turn as a float, its sine and cosine, the scale and its product.
            assertNear(ahead, looking, (2 * PI + 3) * FLOAT_ROUNDING)
        }
    }

    @Test
    fun `a full circle ends where it began`() {
        for ((gear, steering) in listOf(
            GLFW_KEY_W to GLFW_KEY_A,
            GLFW_KEY_W to GLFW_KEY_D,
            GLFW_KEY_S to GLFW_KEY_A,
            GLFW_KEY_S to GLFW_KEY_D,
        )) {
            val frames = 1_000
            val dt = 2 * PI / 1.5 / frames
            val circle = Ride()
            var farthest = 0.0
            repeat(frames) {
                circle.update(HeldKeys(gear, steering), dt)
                farthest = maxOf(farthest, hypot(circle.x, circle.z))
            }
            // Each of 1,000 headings (≤ 2π) rounds and turns the rest of the circle, 2π · 4/1.5 = 17 long; each place (≤ 6) rounds.
            val tolerance = frames * (2 * PI * 17 + 6) * DOUBLE_ROUNDING
            assertNear(Vector3d(), Vector3d(circle.x, 0.0, circle.z), tolerance)
            assertNear(2 * PI, abs(circle.heading), frames * 2 * PI * DOUBLE_ROUNDING)
            // A polygon of 1,000 sides of 4·dt, as wide as its circumcircle.
            assertNear(4 * dt / sin(PI / frames), farthest, tolerance)
        }
    }

    @Test
    fun `A steers left, D right, and in reverse the tail goes there`() {
        drive(60, GLFW_KEY_W, GLFW_KEY_A)
        assertSigns(x = -1, z = -1, heading = 1)
        assertSigns(x = 1, z = -1, heading = -1, of = driven(GLFW_KEY_W, GLFW_KEY_D))
        assertSigns(x = -1, z = 1, heading = -1, of = driven(GLFW_KEY_S, GLFW_KEY_A))
        assertSigns(x = 1, z = 1, heading = 1, of = driven(GLFW_KEY_S, GLFW_KEY_D))
    }

    @Test
    fun `it steers only while driving, and keys against each other do nothing`() {
        drive(60, GLFW_KEY_W, GLFW_KEY_A)
        val before = listOf(ride.x, ride.z, ride.heading)
        drive(60)
        drive(60, GLFW_KEY_A)
        drive(60, GLFW_KEY_D)
        drive(60, GLFW_KEY_W, GLFW_KEY_S, GLFW_KEY_A)
        assertEquals(before, listOf(ride.x, ride.z, ride.heading))
        drive(60, GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_D)
        assertEquals(before.last(), ride.heading)
        assertNotEquals(before.first(), ride.x)
    }

    @Test
    fun `no time moves nothing`() {
        ride.update(HeldKeys(GLFW_KEY_W, GLFW_KEY_A), 0.0)
        assertEquals(listOf(0.0, 0.0, 0.0), listOf(ride.x, ride.z, ride.heading))
    }

    @Test
    fun `it starts at the origin, at 0,8 of its size`() {
        assertNear(Matrix4f().scaling(0.8f), matrix(), 0.0)
    }

    private fun drive(frames: Int, vararg keys: Int) {
        val window = HeldKeys(*keys)
        repeat(frames) { ride.update(window, step) }
    }

    private fun driven(vararg keys: Int) = Ride().apply { repeat(60) { update(HeldKeys(*keys), step) } }

    private fun matrix(): Matrix4f = ride.place(Matrix4f())

    /** Asserts that the matrix stands at the ride's place, and is a turn times 0.8. */
    private fun assertPlaced() {
        val matrix = matrix()
        assertEquals(listOf(ride.x.toFloat(), 0f, ride.z.toFloat()), listOf(matrix.m30(), matrix.m31(), matrix.m32()))
        val axes = matrix.get3x3(Matrix3d())
        // 0.8 as a float, sine and cosine, and their product with it: three roundings in each of two factors, of two terms.
        assertNear(Matrix3d().scaling(0.64), axes.transpose(Matrix3d()).mul(axes), 2 * 3 * 0.64 * FLOAT_ROUNDING)
        assertEquals(listOf(0f, 0.8f, 0f), listOf(matrix.m10(), matrix.m11(), matrix.m12()))
    }

    private fun assertSigns(x: Int, z: Int, heading: Int, of: Ride = ride) {
        assertEquals(listOf(x, z, heading), listOf(of.x, of.z, of.heading).map { if (it > 0) 1 else -1 })
    }
}

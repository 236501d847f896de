package cga.inspect.light

import cga.testing.FLOAT_ROUNDING
import cga.testing.assertNear
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.FloatBuffer
import kotlin.math.PI

class GizmoLinesTest {
    private val buffer = FloatBuffer.allocate(4096 * GizmoLines.FLOATS)
    private val lines = GizmoLines(buffer)
    private val apex = Vector3d(1.0, 2.0, -3.0)

    @Test
    fun `every line of a cone starts at the light or lies on its rim, at the cone's angle`() {
        for (direction in listOf(Vector3d(0.0, 0.0, -1.0), Vector3d(0.0, -1.0, 0.0), Vector3d(1.0, -2.0, 3.0).normalize())) {
            for (angle in listOf(0.0, 0.01, 0.4, PI / 2)) {
                lines.clear()
                lines.cone(apex, direction, angle)
                val rays = vertices().map { it.sub(apex) }
                assertEquals(2 * (GizmoLines.SEGMENTS + GizmoLines.RAYS), rays.size)
                val (atApex, onRim) = rays.partition { it.length() < 0.5 }
                assertEquals(GizmoLines.RAYS, atApex.size)
                for (ray in onRim) {
                    // Positions of up to 9 are rounded to floats, three of them.
                    val rounding = 3 * 9 * FLOAT_ROUNDING
                    assertNear(GizmoLines.LENGTH, ray.length(), rounding)
                    // The cosine of the angle: that itself is not to be had of a tiny difference.
                    assertNear(kotlin.math.cos(angle), ray.normalize().dot(direction), rounding)
                }
            }
        }
    }

    @Test
    fun `the rim goes round once`() {
        lines.clear()
        lines.cone(Vector3d(), Vector3d(0.0, 0.0, -1.0), PI / 2)
        val sum = vertices().filter { it.length() > 1 }.fold(Vector3d()) { sum, it -> sum.add(it) }
        // Opposite points cancel, those of the lines on the cone too.
        assertNear(Vector3d(), sum, 112 * 6 * FLOAT_ROUNDING)
    }

    @Test
    fun `a marker is around the light, with its foot on the ground beneath`() {
        lines.clear()
        lines.marker(apex)
        val (star, foot) = vertices().partition { it.distance(apex) < 0.3 }
        // Seven rays, and the upper end of the plumb line.
        assertEquals(15, star.size)
        assertNear(Vector3d(apex), star.fold(Vector3d()) { sum, it -> sum.add(it) }.div(15.0), 15 * 3 * FLOAT_ROUNDING)
        for (point in foot) assertEquals(0.0, point.y)
        assertTrue(foot.any { it.x == apex.x && it.z == apex.z })
    }

    @Test
    fun `the colour is the light's, as bright as can be, and a black light is grey`() {
        fun color(light: Vector3f): Vector3f {
            lines.clear()
            lines.color(light)
            lines.marker(apex)
            return Vector3f(buffer[3], buffer[4], buffer[5])
        }
        assertEquals(Vector3f(1f, 0.5f, 0.25f), color(Vector3f(16f, 8f, 4f)))
        assertEquals(Vector3f(0.35f), color(Vector3f()))
    }

    @Test
    fun `what does not fit is left out`() {
        val small = GizmoLines(FloatBuffer.allocate(5 * GizmoLines.FLOATS))
        small.cone(apex, Vector3d(0.0, 0.0, -1.0), 0.3)
        assertEquals(4 * GizmoLines.FLOATS, small.vertices.position())
    }

    private fun vertices() =
        (0 until buffer.position() step GizmoLines.FLOATS).map {
            Vector3d(buffer[it].toDouble(), buffer[it + 1].toDouble(), buffer[it + 2].toDouble())
        }
}

package cga.grading.sheet4.scene

import cga.grading.findings.Mistake
import cga.grading.scene.ObservedCone
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.acos
import kotlin.math.cos

class ConeTest {
    @Test
    fun `cones that get wider from the inside out are right, whatever their angles`() {
        for (inner in 1..80 step 3) {
            for (outer in inner + 1..90 step 4) assertEquals(null, mistake(radians(inner), radians(outer)), "$inner° and $outer°")
        }
        for (k in 1..14) assertEquals(null, mistake(0.1 * k, 0.1 * k + 0.05), "${0.1 * k} rad")
    }

    @Test
    fun `inner and outer swapped`() {
        assertEquals(Mistake.CONE_INSIDE_OUT, mistake(radians(30), radians(20)))
        assertEquals(Mistake.CONE_INSIDE_OUT, mistake(0.4, 0.2))
    }

    @Test
    fun `cosines sent and taken for angles`() {
        for (inner in listOf(7, 12, 15, 20)) {
            assertEquals(Mistake.COSINE_OF_COSINE, mistake(cos(radians(inner)), cos(radians(inner + 10))), "$inner°")
        }
    }

    @Test
    fun `degrees taken for radians`() {
        for ((inner, outer) in listOf(15 to 20, 10 to 25, 12 to 17, 20 to 30)) {
            // What is seen is the angle whose cosine the shader took.
            assertEquals(Mistake.DEGREES_FOR_RADIANS, mistake(seen(inner), seen(outer)), "$inner° and $outer°")
        }
    }

    @Test
    fun `degrees made radians twice leave a cone of half a degree`() {
        val (measured, found) = judge(ObservedCone(Vector3d(0.0, 0.0, -1.0), twice(15), twice(25)), "spot")
        assertEquals(Mistake.DEGREES_FOR_RADIANS, found?.mistake)
        assertEquals(1.0, measured?.error)
        val (inner, outer) = listOf(12, 24).map { acos(cos(twice(it)).toFloat().toDouble()) }
        assertEquals(Mistake.DEGREES_FOR_RADIANS, mistake(inner, outer), "sent as cosines")
        // As narrow, and of nobody's degrees.
        assertEquals(null, mistake(0.0041, 0.0077))
    }

    @Test
    fun `nothing sent`() {
        assertEquals(Mistake.CONE_NEVER_SENT, mistake(Double.NaN, Double.NaN))
        assertEquals(Mistake.CONE_NEVER_SENT, mistake(0.0, 0.0))
        assertEquals(Mistake.CONE_NEVER_SENT, mistake(Math.PI / 2, Math.PI / 2))
    }

    @Test
    fun `a hard edge costs, but not all`() {
        val (measured, found) = judge(ObservedCone(Vector3d(0.0, 0.0, -1.0), 0.3, 0.3), "spot")
        assertEquals(Mistake.CONE_HARD_EDGE, found?.mistake)
        assertTrue((measured?.error ?: 0.0) in 0.1..0.9)
    }

    private fun twice(degrees: Int) = Math.toRadians(radians(degrees))

    private fun seen(degrees: Int) = acos(cos(degrees.toDouble()))

    private fun radians(degrees: Int) = Math.toRadians(degrees.toDouble())

    private fun mistake(
        inner: Double,
        outer: Double,
    ) = judge(ObservedCone(Vector3d(0.0, 0.0, -1.0), inner, outer), "spot").second?.mistake

    private fun judge(cone: ObservedCone, name: String) = Cone.axis(cone, name).let { it.measured to it.mistake }
}

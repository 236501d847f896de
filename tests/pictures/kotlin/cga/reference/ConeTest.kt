package cga.reference

import cga.testing.assertNear
import org.joml.Vector3d
import org.junit.jupiter.api.Test
import kotlin.math.cos
import kotlin.math.pow
import kotlin.math.sin

/** The edge of a spotlight, wide and narrow. */
class ConeTest {
    private val axis = Vector3d(0.3, -0.5, -0.8).normalize()

    @Test
    fun `between the angles it is linear in the cosine`() {
        for (theta in listOf(0.0, 20.0, 20.5, 25.0, 30.0, 39.5, 40.0, 60.0, 120.0, 180.0)) {
            val (i, o) = Math.toRadians(20.0) to Math.toRadians(40.0)
            val expected = ((cos(Math.toRadians(theta)) - cos(o)) / (cos(i) - cos(o))).coerceIn(0.0, 1.0)
            // The cosines of the expected value round by 1e-16; their difference is 0.17.
            assertNear(expected, intensity(Math.toRadians(theta), i, o), 1e-14, "$theta°")
        }
    }

    @Test
    fun `narrow cones lose nothing but the rounding of two vectors`() {
        for (degrees in listOf(10.0, 1.0, 0.1, 0.01, 0.001)) {
            val outer = Math.toRadians(degrees)
            for (share in listOf(0.0, 0.5, 0.6, 0.75, 0.9, 0.99, 1.0, 1.1)) {
                // 1 − cos a by its series: a²/2 − a⁴/24 + a⁶/720 − …; the first term left out is 1e-16 of the first at 10°.
                val lit = versine(outer) - versine(share * outer)
                val expected = (lit / (versine(outer) - versine(outer / 2))).coerceIn(0.0, 1.0)
                // Vectors err by some 4e-16, which the angle turns into a share of the cone; I falls by 8/3 over half of it.
                val tolerance = 1e-13 + 8.0 / 3 * 8e-16 / outer
                assertNear(expected, intensity(share * outer, outer / 2, outer), tolerance, "cone of $degrees°, at $share of it")
            }
        }
    }

    private fun versine(a: Double) = a.pow(2) / 2 - a.pow(4) / 24 + a.pow(6) / 720 - a.pow(8) / 40320 + a.pow(10) / 3628800

    private fun intensity(theta: Double, inner: Double, outer: Double): Double {
        val cone = Cone(axis, inner, outer)
        val aside = axis.cross(Vector3d(0.0, 1.0, 0.0), Vector3d()).normalize()
        val ray = Vector3d(axis).mul(cos(theta)).add(aside.mul(sin(theta)))
        return cone.intensity(cone.angle(ray.mul(-3.0)))
    }
}

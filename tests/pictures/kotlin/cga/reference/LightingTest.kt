package cga.reference

import cga.framework.Frame
import cga.framework.FrameCone
import cga.framework.SpecularModel
import cga.testing.DOUBLE_ROUNDING
import cga.testing.assertNear
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/** The formula against values worked out by hand, then the edges of its domain, one after the other. */
class LightingTest {
    @Test
    fun `every term by hand`() {
        // The surface at (0, 0, −2) faces the eye; the light at (2, 0, 0) is 45° off at a distance of √8.
        val light = pointLight(2.0, 0.0, 0.0, Vector3f(2f, 1f, 0.5f), Vector3f(1f, 0f, 0.125f))
        for (model in SpecularModel.entries) {
            val point = shade(frame(lights = listOf(light), ambient = Vector3f(0.25f), specularModel = model), k = 2.0)
            val f = 1 / (1 + 0.125 * 8)
            // Phong: the reflected ray leaves at 45° to the eye. Blinn-Phong: the half vector is at half of that.
            val beta = if (model == SpecularModel.PHONG) PI / 4 else PI / 8
            val share = point.lights.single()
            assertNear(sqrt(8.0), share.distance, TOLERANCE, "d")
            assertNear(f, share.attenuation, TOLERANCE, "F")
            assertEquals(1.0, share.cone, "I")
            assertNear(sqrt(0.5), share.cosAlpha, TOLERANCE, "cos α")
            assertNear(cos(beta), share.cosBeta, TOLERANCE, "cos β")
            assertNear(Vector3d(0.1, 0.2, 0.3), point.emission, TOLERANCE, "M_e·tint")
            assertNear(Vector3d(0.125), point.ambient, TOLERANCE, "M_d·L_a")
            assertNear(Vector3d(2.0, 1.0, 0.5).mul(f * 0.5 * sqrt(0.5)), share.diffuse, TOLERANCE, "diffuse")
            assertNear(Vector3d(2.0, 1.0, 0.5).mul(f * 0.25 * cos(beta) * cos(beta)), share.specular, TOLERANCE, "specular")
            val sum = Vector3d(point.emission).add(point.ambient).add(share.diffuse).add(share.specular)
            assertNear(sum, point.radiance, TOLERANCE, "L_O")
            assertEquals(point.radiance, point.color)
        }
    }

    @Test
    fun `lights add up, and each share is that of the light alone`() {
        val lights = listOf(pointLight(2.0, 0.0, 0.0), pointLight(0.0, 1.0, 1.0, Vector3f(0.5f)))
        val spot = spot(Vector3d(0.0, 0.0, 0.0), Vector3d(0.1, 0.0, -1.0).normalize(), 0.05, 0.2)
        val all = shade(frame(lights = lights + spot))
        val alone = lights.map { frame(lights = listOf(it)) } + frame(lights = listOf(spot))
        assertEquals(3, all.lights.size)
        for ((share, frame) in all.lights.zip(alone)) {
            val only = shade(frame).lights.single()
            assertEquals(only.diffuse, share.diffuse)
            assertEquals(only.specular, share.specular)
        }
        assertTrue(all.lights[2].cone > 0.1 && all.lights[2].cone < 0.9)
        assertNear(0.0996686524911620, all.lights[2].theta, TOLERANCE, "θ = atan 0.1")
    }

    @Test
    fun `gamma encodes the sum, and no negative light`() {
        val frame = frame(gamma = 2f, lights = listOf(pointLight(0.0, 0.0, 0.0, Vector3f(0f, 0f, -9f))))
        val point = shade(frame)
        assertNear(Vector3d(sqrt(0.1), sqrt(0.2), 0.0), point.color, TOLERANCE)
        assertTrue(point.radiance.z < -1)
    }

    @Test
    fun `a light at the fragment does nothing`() {
        for (k in listOf(0.0, 1.0)) {
            val point = shade(frame(lights = listOf(pointLight(0.0, 0.0, -2.0, k = Vector3f(0f, 0f, 1f)))), k = k)
            assertDark(point)
            assertEquals(0.0, point.lights.single().attenuation)
        }
        assertDark(shade(frame(lights = listOf(spot(Vector3d(0.0, 0.0, -2.0), Vector3d(0.0, 0.0, -1.0), 0.1, 0.2)))))
    }

    @Test
    fun `light and eye opposite each other have no half vector`() {
        // Also where rounding leaves something of it: nothing in this direction is exact.
        for (direction in listOf(Vector3d(0.0, 0.0, -1.0), Vector3d(0.3, 0.7, -0.9).normalize())) {
            val position = direction.mul(2.0, Vector3d())
            val light = direction.mul(5.0, Vector3d())
            for (normal in listOf(Vector3d(1.0, 0.0, 0.0), direction, direction.negate(Vector3d()))) {
                val frame = frame(lights = listOf(pointLight(light.x, light.y, light.z)))
                val point = shade(frame, position, normal, k = 0.0)
                assertEquals(Vector3d(), point.lights.single().specular, "$direction $normal")
            }
        }
    }

    @Test
    fun `a cosine of 0 to the power of 0 is 0, any other 1`() {
        // Mirrored, light from (2, 0, −2) comes back along the surface: at right angles to the eye.
        val right = frame(lights = listOf(pointLight(2.0, 0.0, -2.0)), specularModel = SpecularModel.PHONG)
        val point = shade(right, normal = Vector3d(1.0, 0.0, 0.0), k = 0.0)
        assertEquals(0.0, point.lights.single().cosBeta)
        assertEquals(Vector3d(), point.lights.single().specular)
        val other = shade(frame(lights = listOf(pointLight(2.0, 0.0, 0.0))), k = 0.0)
        assertEquals(Vector3d(0.25), other.lights.single().specular)
    }

    @Test
    fun `equal cone angles are a step at the edge`() {
        for ((degrees, expected) in mapOf(0.0 to 1.0, 29.999 to 1.0, 30.001 to 0.0, 90.0 to 0.0, 180.0 to 0.0)) {
            assertEquals(expected, cone(degrees, 30.0, 30.0), "$degrees°")
        }
        assertEquals(1.0, cone(0.0, 0.0, 0.0))
        assertEquals(0.0, cone(1e-9, 0.0, 0.0))
    }

    @Test
    fun `where d² is beyond all floats a light does not shine`() {
        val k = listOf(NO_FALLOFF, Vector3f(1f, 0.5f, 0.1f), Vector3f(0f, 0f, 1f))
        for (distance in listOf(1.85e19, 1e30, 3e38)) {
            for (factors in k) assertDark(shade(frame(lights = listOf(pointLight(0.0, 0.0, distance, k = factors)))))
        }
        assertEquals(1.0, shade(frame(lights = listOf(pointLight(0.0, 0.0, 1.84e19)))).lights.single().attenuation)
    }

    @Test
    fun `without a normal there are emission and ambient`() {
        for (model in SpecularModel.entries) {
            val around = listOf(pointLight(0.0, 0.0, -4.0), pointLight(0.0, 0.0, 0.0), pointLight(2.0, 0.0, -2.0))
            val point = shade(frame(lights = around, ambient = WHITE, specularModel = model), normal = Vector3d(), k = 0.0)
            assertNear(Vector3d(0.6, 0.7, 0.8), point.color, TOLERANCE, "$model")
        }
    }

    @Test
    fun `a light behind the surface still has its highlight, as on the sheet`() {
        val behind = shade(frame(lights = listOf(pointLight(10.0, 0.0, -2.1))), k = 1.0).lights.single()
        assertTrue(behind.cosAlpha < 0)
        assertEquals(Vector3d(), behind.diffuse)
        assertTrue(behind.specular.x > 0.1)
    }

    /** The surface in most tests: at (0, 0, −2), facing the eye, M_e·tint = (0.1, 0.2, 0.3), M_d = 0.5, M_s = 0.25. */
    private fun shade(
        frame: Frame,
        position: Vector3d = Vector3d(0.0, 0.0, -2.0),
        normal: Vector3d = Vector3d(0.0, 0.0, 3.0),
        k: Double = 1.0,
    ): ShadedPoint {
        val lighting = Lighting(frame)
        val point = lighting.newPoint()
        point.position.set(position)
        point.normal.set(normal)
        point.emissive.set(0.1, 0.1, 0.1)
        point.diffuse.set(0.5)
        point.specular.set(0.25)
        lighting.shade(point, Vector3d(1.0, 2.0, 3.0), k)
        return point
    }

    private fun assertDark(point: ShadedPoint) = assertEquals(point.emission, point.color)

    private fun spot(position: Vector3d, direction: Vector3d, inner: Double, outer: Double) =
        pointLight(position.x, position.y, position.z, cone = FrameCone(direction, inner.toFloat(), outer.toFloat()))

    private fun cone(theta: Double, inner: Double, outer: Double): Double {
        val axis = Vector3d(0.0, 0.0, -1.0)
        val cone = Cone(axis, Math.toRadians(inner), Math.toRadians(outer))
        val angle = Math.toRadians(theta)
        return cone.intensity(cone.angle(Vector3d(-sin(angle), 0.0, cos(angle))))
    }

    private companion object {
        /** A dozen roundings of numbers up to 4. */
        const val TOLERANCE = 12 * 4 * DOUBLE_ROUNDING
    }
}

package cga.grading.reading

import cga.grading.sheet4.shading.Shading
import cga.grading.study.SceneCapture
import cga.grading.study.TestScene
import cga.grading.study.VariantCases
import cga.testing.assertNear
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

class CaptureReadingTest {
    private val scene = TestScene()

    @TestFactory
    fun `a correct shader is read as correct, and its numbers are those that were sent`(): List<DynamicTest> =
        VariantCases(scene).all.filter { it.name !in NOT_READ }.map { dynamicTest(it.name) { check(it) } }

    @TestFactory
    fun `what is not read is no mistake with a name`(): List<DynamicTest> =
        VariantCases(scene).all.filter { it.name in NOT_READ }.map { variant ->
            dynamicTest(variant.name) {
                val texts = Shading(reading(variant)).deviations.map { it.text }.distinct()
                assertEquals(listOf("unknown-factor"), texts)
            }
        }

    private fun reading(variant: VariantCases.Variant) = CaptureReading(capture(variant))

    private fun capture(variant: VariantCases.Variant) =
        SceneCapture.of(variant.vertex, variant.fragment, scene) { variant.sent(it, scene.uniforms(it)) }

    private fun check(variant: VariantCases.Variant) {
        val capture = capture(variant)
        val reading = CaptureReading(capture)
        assertEquals(emptyList<String>(), reading.notes)
        assertEquals(emptyList<String>(), Shading(reading).deviations.map { "${it.mistake} ${it.light} ${it.text}" })
        val frame = reading.observe(capture.frames[0]) ?: error("nothing was observed")
        assertEquals(2, frame.objects.size)
        assertEquals(variant.lights, frame.lights.size) { "${frame.lights.map { it.name }}" }
        val expected = listOf(scene.pointPosition, scene.cornerPosition, scene.spotPosition).map { scene.viewed(it) }
        // Uniforms are floats, 24 bits of places up to 30 away; all else is in double precision.
        for (position in expected) assertTrue(frame.lights.any { it.position.distance(position) < 1e-5 }) { "no light at $position" }
        val spot = frame.lights.single { it.spot != null }
        assertNear(Vector3d(2.0, 2.0, 1.8).mul(if ("intensity" in variant.name) 2.5 else 1.0), spot.color, 1e-6, "colour")
        assertNear(Vector3d(0.5, 0.05, 0.01), spot.k, 1e-6, "K")
        val cone = spot.spot ?: error("no cone")
        assertNear(scene.viewedDirection(scene.spotDirection), cone.direction, 1e-6, "direction")
        // An angle from its cosine: the rounding of the cosine divided by the sine of 12.5°.
        assertNear(scene.inner, cone.innerAngle, 1e-6, "inner")
        assertNear(scene.outer, cone.outerAngle, 1e-6, "outer")
        assertNear(Vector3d(0.2, 0.5, 0.6), frame.objects.last().tint ?: error("no tint"), 1e-6, "tint")
    }

    private companion object {
        /** Fog whose factor is limited, so that it is no factor of every term. */
        val NOT_READ = setOf("fog with a beginning and an end")
    }
}

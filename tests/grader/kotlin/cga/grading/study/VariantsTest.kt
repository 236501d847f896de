package cga.grading.study

import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.assertNear
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
@Slow
class VariantsTest {
    private val scene = TestScene()

    @TestFactory
    fun `a correct shader has no mistake and its lights are found`(): List<DynamicTest> = VariantCases(scene).all.map {
        dynamicTest(
            it.name,
        ) { check(it) }
    }

    private fun check(variant: VariantCases.Variant) {
        val capture = SceneCapture.of(variant.vertex, variant.fragment, scene) { variant.sent(it, scene.uniforms(it)) }
        ShaderStudy.of(capture).use { study ->
            assertEquals("", study.notes.joinToString("\n"))
            assertEquals(
                "",
                study.mistakes.joinToString("\n") { "${it.mistake} at ${it.where}: fit ${it.fit}, difference ${it.difference}" },
            )
            // Float arithmetic of a highlight to the power of 60: 60 roundings of a cosine, and as many again in the vectors behind it.
            for (check in study.checks) assertTrue((check.error ?: 0.0) < 2e-3) { "${check.check}: ${check.error} ${check.text}" }
            val frame = study.observe(capture.frames[0]) ?: error("nothing was observed")
            assertEquals(2, frame.objects.size)
            assertEquals(variant.lights, frame.lights.size) { "${frame.lights.map { it.name }}" }
            val expected = listOf(scene.pointPosition, scene.cornerPosition, scene.spotPosition).map { scene.viewed(it) }
            for (position in expected) {
                assertTrue(
                    frame.lights.any {
                        it.position.distance(position) < 1e-3
                    },
                ) { "no light at $position, only ${frame.lights.map { it.position }}" }
            }
            val spot = frame.lights.single { it.spot != null }
            assertNear(Vector3d(2.0, 2.0, 1.8).mul(if ("intensity" in variant.name) 2.5 else 1.0), spot.color, 1e-3, "colour")
            assertNear(Vector3d(0.5, 0.05, 0.01), spot.k, 1e-4, "K")
            val cone = spot.spot ?: error("no cone")
            assertNear(scene.viewedDirection(scene.spotDirection), cone.direction, 1e-4, "direction")
            assertNear(scene.inner, cone.innerAngle, 1e-4, "inner")
            assertNear(scene.outer, cone.outerAngle, 1e-4, "outer")
            assertNear(Vector3d(0.2, 0.5, 0.6), frame.objects.last().tint ?: error("no tint"), 1e-6, "tint")
        }
    }
}

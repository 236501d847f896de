package cga.grading.study

import cga.exercise.components.shader.ShaderSource
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.assertNear
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import kotlin.math.cos

/** The shaders that every starter submission begins with. */
@ExtendWith(Offscreen::class)
@Slow
class OwnShadersTest {
    private val scene = TestScene()

    @Test
    fun `a point light, a corner light and a spotlight are found without a mistake`() = check(2, blinn = true)

    @Test
    fun `eight point lights are found without a mistake`() = check(8, blinn = true)

    private fun check(
        points: Int,
        blinn: Boolean,
    ) {
        val capture = SceneCapture.of(source("scene.vert", points), source("scene.frag", points), scene) { uniforms(it, points, blinn) }
        ShaderStudy.of(capture).use { study ->
            assertEquals("", study.notes.joinToString("\n"))
            assertEquals(
                "",
                study.mistakes.joinToString("\n") { "${it.mistake} at ${it.where}: fit ${it.fit}, difference ${it.difference}" },
            )
            for (check in study.checks) assertTrue((check.error ?: 0.0) < 2e-3) { "${check.check}: ${check.error} ${check.text}" }
            val frame = study.observe(capture.frames[0]) ?: error("nothing was observed")
            assertEquals(points + 1, frame.lights.size)
            for (i in 0 until points) {
                val light = frame.lights.single { it.name == "light[$i].color" }
                assertNear(scene.viewed(place(i)), light.position, 1e-3, "position of light $i")
            }
            val spot = frame.lights.single { it.spot != null }.spot ?: error("no cone")
            assertNear(scene.inner, spot.innerAngle, 1e-4, "inner")
            assertNear(scene.outer, spot.outerAngle, 1e-4, "outer")
            assertNear(Vector3d(0.2, 0.5, 0.6), frame.objects.last().tint ?: error("no tint"), 1e-6, "tint")
        }
    }

    private fun place(i: Int): Vector3d = if (i == 0) scene.pointPosition else Vector3d(-16.0 + 5 * i, 1.2, 16.0 - 3 * i)

    private fun uniforms(
        model: Matrix4dc,
        points: Int,
        blinn: Boolean,
    ): Map<String, Any> {
        val modelView = Matrix4d(scene.view).mul(model)
        val uniforms =
            mutableMapOf<String, Any>(
                "modelView" to modelView,
                "normalMatrix" to Matrix3d(modelView).invert().transpose(),
                "projection" to scene.projection,
                "material.emissive" to 0,
                "material.diffuse" to 1,
                "material.specular" to 2,
                "material.shininess" to 60.0,
                "emissiveTint" to if (model === scene.ground) Vector3d(0.0, 1.0, 0.0) else Vector3d(0.2, 0.5, 0.6),
                "ambient" to Vector3d(),
                "blinnPhong" to if (blinn) 1 else 0,
                "inverseGamma" to 1.0,
                "light[$points].position" to scene.viewed(scene.spotPosition),
                "light[$points].color" to Vector3d(2.0, 2.0, 1.8),
                "light[$points].attenuation" to Vector3d(0.5, 0.05, 0.01),
                "light[$points].direction" to scene.viewedDirection(scene.spotDirection),
                "light[$points].cone" to floatArrayOf((1 - cos(scene.inner)).toFloat(), (1 - cos(scene.outer)).toFloat()),
            )
        for (i in 0 until points) {
            uniforms["light[$i].position"] = scene.viewed(place(i))
            uniforms["light[$i].color"] = Vector3d(0.9, 0.4 + 0.05 * i, 0.7)
            uniforms["light[$i].attenuation"] = Vector3d(1.0, 0.5, 0.1)
            uniforms["light[$i].direction"] = Vector3d()
            uniforms["light[$i].cone"] = floatArrayOf(3f, 4f)
        }
        return uniforms
    }

    private fun source(
        file: String,
        points: Int,
    ): String =
        ShaderSource.read("shaders/$file").text.edited("LIGHTS = 10", "LIGHTS = ${points + 1}")
}

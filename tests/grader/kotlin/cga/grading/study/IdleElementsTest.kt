package cga.grading.study

import cga.framework.context.OffscreenContext
import cga.grading.scene.ObservedFrame
import cga.testing.Slow
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

@Slow
class IdleElementsTest {
    private val scene = TestScene()
    private val first = "result += shade(n, lp, v, diffuse, specular) * pointLightColor * attenuate(dp, pointLightAttenuation);"

    /** [text] with both point lights in arrays. */
    private fun inArrays(text: String): String =
        text
            .replace(Regex("uniform vec3 cornerLight\\w+;\n"), "")
            .replace(Regex("uniform vec3 pointLight(\\w+);"), "uniform vec3 lamp$1[2];")
            .replace(Regex("\\bpointLight(Color|Pos|Attenuation)"), "lamp$1[0]")
            .replace(Regex("\\bcornerLight(Color|Pos|Attenuation)"), "lamp$1[1]")

    private fun observed(fragment: String): ObservedFrame {
        val capture = SceneCapture.of(inArrays(CourseShaders.VERTEX), inArrays(fragment), scene) { model ->
            scene.uniforms(model).mapKeys { (name, _) -> inArrays(name) }
        }
        return OffscreenContext.open().use {
            ShaderStudy.of(capture).use {
                it.observe(capture.frames.single())
                    ?: error("nothing was observed")
            }
        }
    }

    @Test
    fun `an element that is sent and not drawn with is told as the light that it was meant to be`() {
        val frame = observed(CourseShaders.FRAGMENT.edited(first, ""))
        val idle = frame.idle.single()
        assertEquals("lampColor[0]", idle.name)
        // As sent, in floats.
        assertTrue(Vector3d(idle.position).distance(scene.viewed(scene.pointPosition)) < 1e-4) { "${idle.position}" }
        assertTrue(Vector3d(idle.color).distance(Vector3d(0.9, 0.4, 0.7)) < 1e-6) { "${idle.color}" }
        assertEquals(2, frame.lights.size)
    }

    @Test
    fun `no element is idle where all shine`() {
        val frame = observed(CourseShaders.FRAGMENT)
        assertEquals(emptyList<String>(), frame.idle.map { it.name })
        assertEquals(3, frame.lights.size)
    }
}

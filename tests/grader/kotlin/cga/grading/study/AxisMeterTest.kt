package cga.grading.study

import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.assertNear
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

/** A cone that no uniform is the direction of. */
@ExtendWith(Offscreen::class)
@Slow
class AxisMeterTest {
    private val scene = TestScene()
    private val aims = listOf(Vector3d(scene.spotDirection), Vector3d(scene.spotDirection).rotateY(0.7))

    /** View space as the lamp sees it that shines along [aim] from its place. */
    private fun lampSpace(aim: Vector3d) =
        Matrix4d()
            .lookAt(scene.spotPosition, Vector3d(scene.spotPosition).add(aim), Vector3d(0.0, 1.0, 0.0))
            .mul(Matrix4d(scene.view).invert())

    @Test
    fun `a direction that is in a matrix only is followed from draw to draw`() {
        val fragment =
            CourseShaders.FRAGMENT
                .edited("uniform vec3 spotLightDirection;", "uniform mat4 lampSpace;")
                .edited("dot(-l, normalize(spotLightDirection))", "-normalize((lampSpace * vec4(-vertexData.toCamera, 1.0)).xyz).z")
        val capture = SceneCapture.of(CourseShaders.VERTEX, fragment, scene) { model ->
            scene.uniforms(model) - "spotLightDirection" + ("lampSpace" to lampSpace(aims[if (model === scene.ground) 0 else 1]))
        }
        ShaderStudy.of(capture).use { study ->
            assertEquals("", study.mistakes.joinToString { "${it.mistake} at ${it.where}" })
            val frame = study.observe(capture.frames[0]) ?: error("nothing was observed")
            val seen = frame.objects.map { it.lights.single { light -> light.spot != null }.spot?.direction ?: error("no cone") }
            for ((aim, direction) in aims.zip(seen)) assertNear(scene.viewedDirection(aim), direction, 1e-4, "direction")
        }
    }
}

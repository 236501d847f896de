package cga.grading.substitute

import cga.grading.capture.Capture
import cga.grading.capture.CapturedFrame
import cga.grading.capture.CapturedProgram
import cga.grading.capture.Moment
import cga.grading.scene.ObservedFrame
import cga.grading.study.CourseShaders
import cga.grading.study.SceneCapture
import cga.grading.study.ShaderStudy
import cga.grading.study.TestScene
import cga.grading.worker.ShaderStub
import cga.testing.Offscreen
import cga.testing.Slow
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

/**
 * A ride of three pictures, drawn with stand-ins for shaders that do not compile: what is seen of it by the sheet's lighting is compared with
 * what was sent.
 */
@ExtendWith(Offscreen::class)
@Slow
class SubstitutesTest {
    private val scene = TestScene()

    /** Frame by frame, the motorcycle's way from where [scene] has it, and the camera's round it. */
    private val ways: List<Matrix4dc> =
        listOf(Matrix4d(), Matrix4d().translate(1.0, 0.0, -2.0).rotateY(0.4), Matrix4d().translate(4.0, 0.0, -3.0).rotateY(1.0))
    private val views: List<Matrix4dc> = ways.mapIndexed { i, way -> Matrix4d(scene.view).mul(Matrix4d(way).rotateY(0.3 * i).invert()) }

    private fun uniforms(frame: Int, model: Matrix4dc): Map<String, Any> {
        val way = ways[frame]
        return scene.uniforms(model) + mapOf(
            "model_matrix" to if (model === scene.ground) model else way.mul(model, Matrix4d()),
            "view_matrix" to views[frame],
            "pointLightPos" to way.transformPosition(Vector3d(scene.pointPosition)),
            "spotLightPos" to way.transformPosition(Vector3d(scene.spotPosition)),
            "spotLightDirection" to views[frame].transformDirection(way.transformDirection(Vector3d(scene.spotDirection))),
        )
    }

    /** The ride as a worker would have written it; [renamed] are words of the shaders, [sent] changes what a frame sends. */
    private fun capture(
        renamed: Map<String, String> = emptyMap(),
        sent: (Int, Map<String, Any>) -> Map<String, Any> = { _, it -> it },
    ): Capture {
        fun said(text: String) = renamed.entries.fold(text) { all, (old, new) -> all.replace(Regex("\\b$old\\b"), new) }
        val frames = ways.indices.map { frame ->
            SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT, scene) { model ->
                sent(frame, uniforms(frame, model)).mapKeys { said(it.key) }
            }
        }
        val first = frames.first()
        val stub = CapturedProgram(
            ShaderStub(said(CourseShaders.VERTEX), isVertex = true).alone,
            ShaderStub(said(CourseShaders.FRAGMENT), isVertex = false).alone,
            first.programs[0].attributes,
            substituted = true,
        )
        val moments = listOf(Moment.FIRST, Moment.DRIVEN, Moment.STEERED)
        val shown = frames.mapIndexed { i, it -> CapturedFrame(moments[i], i.toDouble(), it.frames[0].steps, null) }
        return Capture(first.width, first.height, listOf(stub), first.buffers, first.textures, shown, emptyList())
    }

    private fun observed(substitutes: Substitutes): List<ObservedFrame> =
        ShaderStudy.of(substitutes.capture).use { study -> substitutes.capture.frames.map { study.observe(it) ?: error(study.notes) } }

    /** Float uniforms, a product of two of them, and places found by probing: 1e-3 of distances of some ten units. */
    private fun assertNear(expected: Vector3dc, actual: Vector3dc, what: String) =
        assertTrue(expected.distance(actual) < 1e-2, "$what is $actual, wanted $expected")

    private fun assertSeen(frames: List<ObservedFrame>, point: String, spot: String) {
        frames.forEachIndexed { i, frame ->
            val back = frame.view.invert(Matrix4d())

            fun light(name: String) = frame.lights.single { it.name == name }

            fun place(name: String) = back.transformPosition(Vector3d(light(name).position))
            assertNear(ways[i].transformPosition(Vector3d(scene.pointPosition)), place(point), "point light")
            assertNear(ways[i].transformPosition(Vector3d(scene.spotPosition)), place(spot), "spotlight")
            val headlight = light(spot)
            val axis = headlight.spot?.direction ?: error("no cone in picture $i")
            assertNear(ways[i].transformDirection(Vector3d(scene.spotDirection)), back.transformDirection(Vector3d(axis)), "direction")
            assertNear(Vector3d(0.5, 0.05, 0.01), headlight.k, "K")
            assertEquals(2, frame.objects.size)
        }
        assertEquals(listOf(Vector3d(0.0, 1.0, 0.0), Vector3d(0.2f.toDouble(), 0.5, 0.6f.toDouble())), frames[0].objects.map { it.tint })
    }

    @Test
    fun `a scene is seen as it was sent`() {
        val substitutes = Substitutes.of(capture())
        assertTrue(substitutes.isRead && substitutes.isWhole)
        assertSeen(observed(substitutes), "pointLightColor", "spotLightColor")
    }

    @Test
    fun `German words and other forms are understood`() {
        val german = mapOf(
            "pointLightPos" to "lampe_ort", "pointLightColor" to "lampe_farbe", "pointLightAttenuation" to "lampe_k",
            "spotLightPos" to "strahler_ort", "spotLightColor" to "strahler_farbe", "spotLightAttenuation" to "strahler_k",
            "spotLightDirection" to "strahler_richtung", "spotInner" to "innen", "spotOuter" to "aussen", "sceneColour" to "anstrich",
            "model_matrix" to "modell", "view_matrix" to "kamera", "projection_matrix" to "bild",
        )
        val substitutes = Substitutes.of(capture(german) { _, sent -> sent + mapOf("spotInner" to 12.5, "spotOuter" to 25.0) })
        assertTrue(substitutes.isRead && substitutes.isWhole)
        val frames = observed(substitutes)
        assertSeen(frames, "lampe_farbe", "strahler_farbe")
        // 25 degrees, by a profile of angles a degree apart.
        assertEquals(scene.outer, frames[0].lights.single { it.name == "strahler_farbe" }.spot?.outerAngle ?: 0.0, 0.01)
    }

    @Test
    fun `places in view space are told from places in the world, and a direction the other way round is turned`() {
        val viewed = capture { frame, sent ->
            fun vector(name: String) = Vector3d(sent.getValue(name) as Vector3d)
            val places = listOf("pointLightPos", "cornerLightPos", "spotLightPos")
            sent + places.associateWith { views[frame].transformPosition(vector(it)) } +
                ("spotLightDirection" to vector("spotLightDirection").negate())
        }
        assertSeen(observed(Substitutes.of(viewed)), "pointLightColor", "spotLightColor")
    }

    @Test
    fun `a vector that nothing is known of leaves the reading incomplete`() {
        val substitutes = Substitutes.of(capture(mapOf("cornerLightPos" to "mystery")))
        assertTrue(substitutes.isRead)
        assertFalse(substitutes.isWhole)
    }

    @Test
    fun `without a way to the screen nothing is read, and a program that compiles is left alone`() {
        assertFalse(Substitutes.of(capture { _, sent -> sent - "projection_matrix" }).isRead)
        val own = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT)
        assertTrue(Substitutes.of(own).capture === own)
    }
}

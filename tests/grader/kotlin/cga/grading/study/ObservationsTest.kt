package cga.grading.study

import cga.framework.context.OffscreenContext
import cga.grading.capture.Capture
import cga.grading.capture.CapturedFrame
import cga.grading.scene.ObservedFrame
import cga.testing.Slow
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

@Slow
class ObservationsTest {
    private val scene = TestScene()
    private val above = Matrix4d().lookAt(Vector3d(0.0, 30.0, 0.0), Vector3d(), Vector3d(0.0, 0.0, -1.0))

    private fun draws(capture: Capture) = capture.draws

    /** The scene, then once more in the viewport [inset], seen from above. */
    private fun observed(inset: List<Int>): ObservedFrame {
        val plain = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT, scene)
        val map = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT, scene) { scene.uniforms(it) + ("view_matrix" to above) }
        val second = draws(map).map { it.copied(it.state.copy(viewport = inset)) }
        val frame = plain.frames.single()
        val both = CapturedFrame(frame.moment, frame.time, draws(plain) + second, null)
        val capture = with(plain) { Capture(width, height, programs, buffers, textures, listOf(both), events) }
        return OffscreenContext.open().use { ShaderStudy.of(capture).use { it.observe(both) ?: error("nothing was observed") } }
    }

    private fun isSeenFrom(view: Matrix4d, frame: ObservedFrame): Boolean {
        val place = view.transformPosition(scene.pointPosition, Vector3d())
        // As sent, in floats.
        return frame.lights.any { Vector3d(it.position).distance(place) < 1e-3 }
    }

    @Test
    fun `a map of the scene in a corner is no part of it`() {
        val frame = observed(listOf(1000, 500, 256, 144))
        assertTrue(isSeenFrom(Matrix4d(scene.view), frame))
        assertEquals(2, frame.objects.size)
    }

    @Test
    fun `what fills the picture, the last that is drawn, is how the lights are seen`() {
        assertTrue(isSeenFrom(above, observed(listOf(0, 0, 1280, 720))))
    }

    @Test
    fun `a trail without light, drawn last, does not hide the lights`() {
        val plain = SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT, scene)
        val trail = SceneCapture.of(CourseShaders.VERTEX, TRAIL, scene)
        val frame = plain.frames.single()
        val both = CapturedFrame(frame.moment, frame.time, draws(plain) + draws(trail).last().copied(program = 1), null)
        val capture = with(plain) { Capture(width, height, programs + trail.programs, buffers, textures, listOf(both), events) }
        val seen = OffscreenContext.open().use { ShaderStudy.of(capture).use { it.observe(both) ?: error("nothing was observed") } }
        assertTrue(isSeenFrom(Matrix4d(scene.view), seen))
    }

    private companion object {
        val TRAIL =
            """
            #version 330 core
            out vec4 color;
            void main() {
                color = vec4(0.2, 0.5, 0.9, 1.0);
            }
            """.trimIndent()
    }
}

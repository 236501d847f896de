package cga.grading.study

import cga.framework.context.OffscreenContext
import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import cga.grading.capture.DrawState
import cga.grading.scene.ObservedFrame
import cga.testing.Slow
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.GL_ONE
import org.lwjgl.opengl.GL33C.GL_ONE_MINUS_SRC_ALPHA

@Slow
class LightPassesTest {
    private val scene = TestScene()
    private val moved = Vector3d(4.0, 1.0, 2.0)

    /** The scene drawn twice, the second time with its point light elsewhere and blended as told. */
    private fun observed(
        source: Int = GL_ONE,
        destination: Int = GL_ONE,
        second: (List<CapturedDraw>) -> List<CapturedDraw> = { it },
    ): ObservedFrame {
        val plain = capture { scene.uniforms(it) }
        val other = capture { scene.uniforms(it) + ("pointLightPos" to moved) }
        val state = { draw: CapturedDraw -> draw.state.copy(blend = true, blendSource = source, blendDestination = destination) }
        val added = draws(other).map { it.copied(state(it)) }
        val frame = plain.frames.single()
        val both = CapturedFrame(frame.moment, frame.time, draws(plain) + second(added), null)
        val capture = with(plain) { Capture(width, height, programs, buffers, textures, listOf(both), events) }
        return OffscreenContext.open().use { ShaderStudy.of(capture).use { it.observe(both) ?: error("nothing was observed") } }
    }

    private fun capture(uniforms: (Matrix4dc) -> Map<String, Any>) =
        SceneCapture.of(CourseShaders.VERTEX, CourseShaders.FRAGMENT, scene, uniforms)

    private fun draws(capture: Capture) = capture.draws

    private fun places(frame: ObservedFrame) = frame.lights.map { light -> Vector3d(light.position) }

    private fun isAmong(place: Vector3d, frame: ObservedFrame) = places(frame).any { it.distance(scene.viewed(place)) < 1e-3 }

    @Test
    fun `lights of passes that add up shine together, each by a name of its own`() {
        val frame = observed()
        // Three lights, each in both passes.
        assertEquals(6, frame.lights.size)
        assertEquals(6, frame.lights.map { it.name }.distinct().size)
        assertEquals(true to true, isAmong(scene.pointPosition, frame) to isAmong(moved, frame))
        assertEquals(2, frame.objects.size)
    }

    @Test
    fun `what hides the picture before is no further pass`() {
        val frame = observed(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
        assertEquals(3, frame.lights.size)
        assertEquals(false to true, isAmong(scene.pointPosition, frame) to isAmong(moved, frame))
    }

    @Test
    fun `something else that is added is no further pass`() {
        val frame = observed { added -> added.map { it.copied(count = it.count - 3) } }
        assertEquals(3, frame.lights.size)
    }
}

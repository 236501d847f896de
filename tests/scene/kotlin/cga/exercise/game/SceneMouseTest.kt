package cga.exercise.game

import cga.framework.Frame
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.HeldKeys
import cga.testing.assertNear
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector4d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.IEEErem
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.random.Random

/** The sheet's 4.5: the mouse takes the camera about the motorcycle without losing it from focus. */
class SceneMouseTest {
    private val scene = Scene(HeldKeys())

    @Test
    fun `after a million events the camera is where their sum says, and a full circle on`() {
        val random = Random(1)
        val start = 640.25
        var x = start
        scene.onMouseMove(x, 0.0)
        repeat(1_000_000) {
            // Quarters of a pixel: their sums are exact. More to the right than to the left, some three thousand turns.
            x += random.nextInt(-400, 440) / 4.0
            scene.onMouseMove(x, random.nextDouble(720.0))
        }
        repeat(3_200) {
            x += 1.0
            scene.onMouseMove(x, 0.0)
            assertOrbits(0.002 * (x - start))
        }
    }

    @Test
    fun `the first event never jumps`() {
        scene.onMouseMove(98_765.0, 43_210.0)
        assertOrbits(0.0)
    }

    @Test
    fun `only x counts`() {
        scene.onMouseMove(0.0, 0.0)
        scene.onMouseMove(0.0, 500.0)
        assertOrbits(0.0)
        scene.onMouseMove(100.0, -500.0)
        assertOrbits(0.2)
    }

    @Test
    fun `the steps before 4,5 do not turn, and 4,5 does not jump`() {
        scene.onMouseMove(0.0, 0.0)
        var x = 0.0
        for (step in Step.entries.filter { it < Step.ORBIT }) {
            scene.step = step
            x += 100
            scene.onMouseMove(x, 0.0)
            assertOrbits(0.0)
        }
        for (step in Step.entries.filter { it >= Step.ORBIT }) {
            scene.step = step
            scene.onMouseMove(x, 0.0)
            assertOrbits(0.0)
        }
        scene.onMouseMove(x + 100, 0.0)
        assertOrbits(0.2)
        scene.step = Step.COLOR
        assertOrbits(0.0)
    }

    /** Asserts the angle, and what holds for every angle: distance, horizon, focus. */
    private fun assertOrbits(angle: Double) {
        val frame = scene.frame()
        val view = Matrix4d(frame.view)
        val back = Vector3d(view.m02(), view.m12(), view.m22())
        // The tolerance. The double sums of a million events stay within 1e-9, the float matrix within 4e-7.
        val error = (atan2(back.x, back.z) - angle).IEEErem(2 * PI)
        assertTrue(abs(error) <= 1e-6) { "turned ${atan2(back.x, back.z)}, should be $angle: off by $error" }

        val motorcycle = view.transformPosition(position(frame))
        // 4 in the motorcycle's units of 0.8. The float matrices: the scale, the axis' sines and cosines and their products.
        assertNear(3.2, motorcycle.length(), 3.2 * 6 * FLOAT_ROUNDING)
        // The camera's world x axis is level but for the rounding of the four products of its other axes: 4 · 1/4 roundings.
        assertNear(0.0, view.m10(), FLOAT_ROUNDING)
        // The origin lies on the camera's −z axis: 4 is a power of two, so float rounding does not move it off.
        val clip = Matrix4d(frame.projection).transform(Vector4d(motorcycle, 1.0))
        assertNear(Vector3d(0.0, 0.0, 1.0), Vector3d(clip.x / clip.w, clip.y / clip.w, 1.0), 16 * DOUBLE_ROUNDING)
        assertTrue(clip.w > 0 && abs(clip.z) < clip.w) { "in front of the camera: $clip" }
    }

    /** Where the motorcycle is, in world space. */
    private fun position(frame: Frame): Vector3d = frame.draws.last().model.getTranslation(Vector3d())
}

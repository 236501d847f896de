package cga.exercise.game

import cga.framework.Frame
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.assertNear
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertTimeout
import java.time.Duration

class ScriptedSceneTest {
    private val script = "W 1, WA 0.7, SD 0.55, 0.3, W 0.2"

    @Test
    fun `to a time in one go or in many steps is the same, to the last bit`() {
        val inSteps = scene(script)
        var now = 0.0
        for (t in listOf(0.1, 0.7, 1.0, 1.234567, 2.5, 3.0)) {
            while (now < t) {
                inSteps.advanceTo(now)
                now += 0.00123
            }
            inSteps.advanceTo(t)
            val atOnce = scene(script).apply { advanceTo(t) }
            assertEquals(numbers(atOnce.scene.frame()), numbers(inSteps.scene.frame()), "at $t s")
        }
    }

    @Test
    fun `ten million seconds are as quick as ten`() {
        val scene = scene(script)
        // Minutes, were the 1.2e9 updates made.
        assertTimeout(Duration.ofSeconds(2)) { scene.advanceTo(1e7) }
        assertEquals(position(scene(script).apply { advanceTo(10.0) }), position(scene))
    }

    @Test
    fun `it drives for as long as the script says`() {
        // 4 units a second; 240 sums of up to 8, and one rounding to a float.
        val tolerance = 8 * FLOAT_ROUNDING + 240 * 8 * DOUBLE_ROUNDING
        for ((t, way) in listOf(1.5 to 6.0, 2.0 to 8.0, 9.0 to 8.0)) {
            assertNear(Vector3d(0.0, 0.0, -way), position(scene("W 2").apply { advanceTo(t) }), tolerance)
        }
    }

    @Test
    fun `a 120th of a second is an update`() {
        val scene = scene("W 2")
        for (update in 1..240) {
            scene.advanceTo(update / 120.0)
            assertNear(Vector3d(0.0, 0.0, -4 * update / 120.0), position(scene), 8 * FLOAT_ROUNDING + 240 * 8 * DOUBLE_ROUNDING)
        }
    }

    @Test
    fun `there and back is home, however the way is cut`() {
        // Sums of tenths are not exact: 0.1 + 0.1 + 0.1 > 0.3. That must not give one direction an update more.
        val ways = listOf("W 0.1, S 0.1", "W 0.1, W 0.1, W 0.1, S 0.3", "W 0.7, W 0.1, S 0.8", "S 0.3, W 0.2, W 0.1")
        for (way in ways) {
            val home = scene(way).apply { advanceTo(5.0) }
            // 200 sums of up to 3.2.
            assertNear(Vector3d(), position(home), 200 * 3.2 * DOUBLE_ROUNDING, way)
        }
    }

    @Test
    fun `the picture has the size it is asked for`() {
        val projection = ScriptedScene(300, 100).scene.frame().projection
        assertNear(3.0, projection.m11() / projection.m00(), 3 * 3 * FLOAT_ROUNDING)
    }

    @Test
    fun `the mouse starts where it is`() {
        val scene = scene("")
        val before = numbers(scene.scene.frame())
        scene.moveMouseTo(0.0)
        assertEquals(before, numbers(scene.scene.frame()))
    }

    private fun scene(drive: String) =
        ScriptedScene(160, 90, Step.FINAL, if (drive.isEmpty()) DriveScript.NONE else DriveScript.parse(drive))

    private fun position(scene: ScriptedScene) =
        scene.scene
            .frame()
            .draws
            .last()
            .model
            .getTranslation(Vector3d())

    /** Every number of the frame that moves. */
    private fun numbers(frame: Frame): List<Any> =
        listOf(frame.view, frame.projection) + frame.draws.flatMap { listOf(it.model, it.tint) } +
            frame.lights.flatMap { listOfNotNull(it.position, it.color, it.cone?.direction) }
}

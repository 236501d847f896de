package cga.inspect.record

import cga.exercise.game.Scene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.framework.InputError
import cga.inspect.view.Look
import cga.testing.HeldKeys
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.glfw.GLFW.*
import java.nio.file.Path
import kotlin.random.Random

/** Input that is recorded, written, read and replayed makes the same scene, to the last bit. */
class RecordingTest {
    @Test
    fun `a replay is the scene that was recorded, after every update`(
        @TempDir folder: Path,
    ) {
        val window = HeldKeys()
        val scene = Scene(window, Step.COLOR)
        val recorder = Recorder(Step.COLOR, Look())
        val random = Random(7)
        val frames = ArrayList<List<Any>>()
        repeat(400) { update ->
            if (random.nextInt(10) == 0) window.keys.toggle(KEYS.random(random))
            if (random.nextInt(3) == 0 || update == 0) {
                val x = random.nextDouble(-2000.0, 2000.0)
                recorder.mouse(x)
                scene.onMouseMove(x, 0.0)
            }
            if (random.nextInt(40) == 0) {
                val key = (GLFW_KEY_1..GLFW_KEY_8).random(random).let { if (random.nextBoolean()) it else GLFW_KEY_B }
                recorder.press(key)
                scene.onKey(key, 0, GLFW_PRESS, 0)
            }
            recorder.update(window)
            scene.update(1.0 / 120, recorder.updates * (1.0 / 120))
            if (update % 100 == 99) recorder.picture()
            frames += numbers(scene.frame())
        }
        val file = folder.resolve("recording.txt")
        recorder.recording().write(file)
        val recording = Recording.read(file)
        assertEquals(400, recording.updates)
        assertEquals(listOf(100, 200, 300, 400), recording.pictures)
        val replay = Replay(recording, 1280, 720)
        for ((i, expected) in frames.withIndex()) {
            // Events between two updates belong to the next picture: they are applied when its update comes.
            replay.advanceTo(i + 1)
            if (recording.events.none { it.first == i + 1 && it.second != Event.Picture }) {
                assertEquals(expected, numbers(replay.scene.frame()), "after ${i + 1} updates")
            }
        }
    }

    @Test
    fun `what is written is read again`() {
        val events =
            listOf(
                0 to Event.Mouse(0.0), 0 to Event.Hold("WA"), 3 to Event.Mouse(-1.5E-5), 3 to Event.Hold(""), 9 to Event.Press(52),
                9 to Event.Turn("scene.L_a.red", 0.1f), 9 to Event.Turn("cornerLight1.x", -1.0E-4f), 9 to Event.Reset, 9 to Event.Picture,
            )
        val text = Recording(Step.BLINN_PHONG, events, 12).toText()
        val read = Recording.parse(text, "x")
        assertEquals(listOf(Step.BLINN_PHONG, events, 12), listOf(read.step, read.events, read.updates))
        assertEquals(text, read.toText())
    }

    @Test
    fun `what is no recording is refused with its line`() {
        val start = "cga recording 2, step 4.7"
        val wrong =
            mapOf(
                "" to "does not begin",
                "hello" to "does not begin",
                "cga recording 2, step 9.9\n0 end" to "does not begin",
                start to "no line",
                "$start\n0 hold X\n1 end" to "line 2",
                "$start\n5 hold W\n4 hold A\n6 end" to "line 3",
                "$start\n1 mouse NaN\n2 end" to "line 2",
                "$start\n99999999 end" to "line 2",
                "$start\n1 end\n2 hold W" to "line 3",
                "$start\n1 press 52\n" to "no line",
                "$start\n1 turn scene.gamma NaN\n2 end" to "line 2",
                "cga recording 1, step 4.7\n0 end" to "format 1",
                "cga recording 3, step 4.7\n0 end" to "format 3",
            )
        for ((text, part) in wrong) {
            val message = assertThrows<InputError>(text) { Recording.parse(text, "a.txt") }.message.orEmpty()
            assertTrue("a.txt" in message && part in message) { "$text: $message" }
        }
    }

    @Test
    fun `what the scene cannot be turned to is refused`() {
        val wrong = listOf("scene.colour" to 1f, "scene.gamma" to 99f, "view" to 99f, "view" to 1.5f, "divider" to 2f, "off" to -1f)
        for ((name, value) in wrong) {
            val recording = Recording(Step.FINAL, listOf(0 to Event.Turn(name, value)), 1)
            val message = assertThrows<InputError>("$name $value") { Replay(recording, 16, 9) }.message.orEmpty()
            assertTrue("$name to $value" in message, message)
        }
    }

    private fun MutableSet<Int>.toggle(key: Int) {
        if (!add(key)) remove(key)
    }

    /** Every number of the frame that moves. */
    private fun numbers(frame: Frame): List<Any> =
        listOf(frame.view, frame.projection, frame.specularModel) + frame.draws.flatMap { listOf(it.model, it.tint) } +
            frame.lights.flatMap { listOf(it.position, it.color, it.attenuation) }

    private companion object {
        val KEYS = listOf(GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D)
    }
}

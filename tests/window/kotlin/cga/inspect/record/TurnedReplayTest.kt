package cga.inspect.record

import cga.coach.ui.Ui
import cga.exercise.game.Scene
import cga.exercise.game.Step
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.WindowState
import cga.inspect.Actions
import cga.inspect.Clock
import cga.inspect.ControlPanel
import cga.inspect.InspectedScene
import cga.inspect.tune.Tuning
import cga.inspect.view.InspectedProgram
import cga.inspect.view.Look
import cga.inspect.view.Traffic
import cga.inspect.view.View
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.glfw.GLFW.*

/** Whatever the panel and the keys do to the picture is in the recording: each frame of the replay has the bytes of the frame played. */
@ExtendWith(Offscreen::class)
@Slow
class TurnedReplayTest {
    private val window =
        object : WindowState {
            override val framebufferWidth = WIDTH
            override val framebufferHeight = HEIGHT

            override fun getKeyState(key: Int) = key == GLFW_KEY_W
        }
    private val look = Look()
    private val traffic = Traffic()
    private val scene = Scene(window, Step.FINAL) { v, f, constants -> InspectedProgram(v, f, constants, look, traffic) }
    private val recorder = Recorder(Step.FINAL, look)
    private val tuning = Tuning(scene, recorder::turn, recorder::reset)
    private val inspected = InspectedScene(scene, look, tuning)

    @Test
    fun `every knob and every way to look, turned one after the other, replays to the same bytes`() {
        val turns = tuning.knobs.values.map { { tuning.turn(it, it.min + 0.37f * (it.max - it.min)) } } + looks() + { tuning.reset() }
        val played = turns.map { turn -> frame().also { turn() } } + frame()
        // Nearly all of them show, or this would prove little: not the cone's outer angle when the inner has pushed it, for example.
        val changes = played.zipWithNext().count { (a, b) -> !a.contentEquals(b) }
        assertTrue(changes > turns.size * 0.9) { "$changes of ${turns.size}" }

        assertReplayed(played)
    }

    @Test
    fun `whatever is clicked in the panel, the arrows of its numbers too, replays to the same bytes`() {
        val played = ArrayList<ByteArray>()
        Ui(1f).use { ui ->
            val panel = ControlPanel(scene, look, tuning, Clock(), Actions({}, {}, {}))
            // From top to bottom, where the numbers have an arrow: a click on a title unfolds what is below, which the next ones hit.
            for (y in 40 until PANEL_HEIGHT - 10 step ROW) {
                played += frame()
                ui.click(panel, y.toDouble())
            }
        }
        played += frame()
        val turned = recorder.recording().events.mapNotNull { (it.second as? Event.Turn)?.name }.toSet()
        assertTrue(turned.count { it in tuning.knobs } >= 5) { "the numbers that were hit: $turned" }
        assertReplayed(played)
    }

    private fun Ui.click(
        panel: ControlPanel,
        y: Double,
    ) = RenderTarget(PANEL_WIDTH, PANEL_HEIGHT, 0, ColorFormat.RGBA8).use { target ->
        input.move(PANEL_WIDTH - ARROW, y)
        for (action in listOf(GLFW_PRESS, GLFW_RELEASE)) {
            input.button(GLFW_MOUSE_BUTTON_LEFT, action)
            target.bind()
            begin()
            panel.draw(this, PANEL_WIDTH.toFloat(), PANEL_HEIGHT.toFloat())
            end(PANEL_WIDTH, PANEL_HEIGHT)
        }
    }

    private fun assertReplayed(played: List<ByteArray>) {
        val text = recorder.recording().toText()
        val recording = Recording.parse(text, "recording")
        assertEquals(text, recording.toText())
        Replay(recording, WIDTH, HEIGHT).use { replay ->
            for ((i, expected) in played.withIndex()) {
                replay.advanceToPicture()
                assertArrayEquals(expected, picture(replay::draw), "frame $i")
            }
        }
        assertFalse(played.first().contentEquals(played.last()))
        inspected.close()
        scene.cleanup()
    }

    private fun looks(): List<() -> Unit> =
        View.entries.map { { look.view = it } } +
            listOf(
                { look.light = 2 },
                { look.view = View.FULL },
                { look.solo(5) },
                { look.switch(0, true) },
                { look.hasGizmos = true },
                { look.isSplit = true },
                { look.divider = 0.3f },
                { press(GLFW_KEY_3) },
                { press(GLFW_KEY_8) },
                { press(GLFW_KEY_B) },
                { look.reset() },
            )

    private fun press(key: Int) {
        recorder.press(key)
        scene.onKey(key, 0, GLFW_PRESS, 0)
        inspected.stepChanged()
    }

    /** As in the window: an update and a picture; what somebody turns then the next picture shows. */
    private fun frame(): ByteArray {
        recorder.update(window)
        scene.update(1.0 / Replay.RATE, recorder.updates * (1.0 / Replay.RATE))
        recorder.picture()
        return picture {
            inspected.draw(WIDTH, HEIGHT)
            inspected.drawGizmos()
        }
    }

    private fun picture(draw: () -> Unit): ByteArray =
        RenderTarget(WIDTH, HEIGHT, 0, ColorFormat.RGBA8).use { target ->
            target.bind()
            draw()
            target.read().rgba
        }

    private companion object {
        const val WIDTH = 96
        const val HEIGHT = 54
        const val PANEL_WIDTH = 400
        const val PANEL_HEIGHT = 900

        /** Less than a row would fold again what was unfolded. */
        const val ROW = 26

        /** From the right edge to the arrows that make a number larger. */
        const val ARROW = 35.0
    }
}

package cga.inspect.record

import cga.exercise.game.Scene
import cga.framework.InputError
import cga.framework.WindowState
import cga.inspect.InspectedScene
import cga.inspect.tune.Tuning
import cga.inspect.view.InspectedProgram
import cga.inspect.view.Look
import cga.inspect.view.LookNumber
import cga.inspect.view.Traffic
import org.lwjgl.glfw.GLFW.GLFW_PRESS

/**
 * The scene without a window, with a [recording] for its input: the same pictures as in the window, frame by frame. Throws [InputError]
 * where the recording turns what the scene does not have.
 *
 * @param framebufferWidth of the pictures in pixels, likewise [framebufferHeight].
 */
public class Replay(
    private val recording: Recording,
    override val framebufferWidth: Int,
    override val framebufferHeight: Int,
) : WindowState,
    AutoCloseable {
    private val look = Look()
    private val traffic = Traffic()
    private var held = ""
    private var next = 0
    private var updates = 0

    /** The scene, as it was after the last [advanceTo]. */
    internal val scene: Scene = Scene(this, recording.step) { v, f, constants -> InspectedProgram(v, f, constants, look, traffic) }
    private val tuning = Tuning(scene)
    private val inspected = InspectedScene(scene, look, tuning)

    init {
        for ((_, event) in recording.events) if (event is Event.Turn) check(event)
    }

    override fun getKeyState(key: Int): Boolean = Recorder.KEYS.indexOf(key).let { it >= 0 && Recorder.LETTERS[it] in held }

    /** Brings the scene to the state after [update] updates, not fewer than the last time. */
    public fun advanceTo(update: Int) {
        require(update >= updates) { "update $update is before $updates: a replay does not run backwards" }
        while (updates < update) {
            while (hasEvent) apply(recording.events[next++].second)
            update()
        }
        while (hasEvent) apply(recording.events[next++].second)
    }

    /** Brings the scene to where the next screenshot was taken; what came after it, though before the next update, is still to come. */
    public fun advanceToPicture() {
        while (updates < recording.updates || hasEvent) {
            if (!hasEvent) {
                update()
                continue
            }
            val event = recording.events[next++].second
            apply(event)
            if (event == Event.Picture) return
        }
        error("the recording has no further picture")
    }

    /** Draws the window's picture, without its panels, into the framebuffer that is bound. */
    public fun draw() {
        inspected.draw(framebufferWidth, framebufferHeight)
        inspected.drawGizmos()
    }

    /** Frees everything on the GPU. */
    override fun close() {
        inspected.close()
        scene.cleanup()
    }

    private val hasEvent get() = next < recording.events.size && recording.events[next].first <= updates

    private fun update() {
        updates++
        scene.update(STEP, updates * STEP)
    }

    private fun apply(event: Event) {
        when (event) {
            is Event.Hold -> held = event.keys
            is Event.Mouse -> scene.onMouseMove(event.x, 0.0)
            is Event.Press -> press(event.key)
            is Event.Turn -> turn(event)
            Event.Reset -> tuning.reset()
            Event.Picture -> {}
        }
    }

    private fun press(key: Int) {
        val step = scene.step
        scene.onKey(key, 0, GLFW_PRESS, 0)
        if (scene.step != step) inspected.stepChanged()
    }

    private fun turn(event: Event.Turn) {
        LOOK[event.name]?.let { return it.set(look, event.value) }
        // In the window the panel turns what was just drawn: one channel of a colour leaves the others as they are at that time.
        scene.frame()
        tuning.turn(tuning.knobs.getValue(event.name), event.value)
    }

    private fun check(turn: Event.Turn) {
        val isTaken = LOOK[turn.name]?.takes(turn.value) ?: tuning.knobs[turn.name]?.let { turn.value in it.min..it.max } ?: false
        if (!isTaken) throw InputError("the recording turns ${turn.name} to ${turn.value}, which the scene does not have: record it again.")
    }

    public companion object {
        /** Updates a second. */
        public const val RATE: Int = 120
        private const val STEP = 1.0 / RATE
        private val LOOK = LookNumber.entries.associateBy { it.word }
    }
}

package cga.inspect.record

import cga.exercise.game.Scene
import cga.framework.WindowState
import org.lwjgl.glfw.GLFW.GLFW_PRESS

/**
 * The scene without a window, with a [recording] for its input: the same pictures as in the window, frame by frame.
 *
 * @param framebufferWidth of the pictures in pixels, likewise [framebufferHeight].
 */
public class Replay(
    private val recording: Recording,
    override val framebufferWidth: Int,
    override val framebufferHeight: Int,
) : WindowState {
    private var held = ""
    private var next = 0
    private var updates = 0

    /** The scene, as it was after the last [advanceTo]. */
    public val scene: Scene = Scene(this, recording.step)

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

    private val hasEvent get() = next < recording.events.size && recording.events[next].first <= updates

    private fun update() {
        updates++
        scene.update(STEP, updates * STEP)
    }

    private fun apply(event: Event) {
        when (event) {
            is Event.Hold -> held = event.keys
            is Event.Mouse -> scene.onMouseMove(event.x, 0.0)
            is Event.Press -> scene.onKey(event.key, 0, GLFW_PRESS, 0)
            Event.Picture -> {}
        }
    }

    public companion object {
        /** Updates a second. */
        public const val RATE: Int = 120
        private const val STEP = 1.0 / RATE
    }
}

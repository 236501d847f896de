package cga.inspect.record

import cga.exercise.game.Step
import cga.framework.WindowState
import cga.inspect.view.Look
import cga.inspect.view.LookNumber
import org.lwjgl.glfw.GLFW.*

/** Writes down what happens to a scene and how it is looked at, from its first update on. Allocates only when something changes. */
internal class Recorder(
    private val step: Step,
    private val look: Look,
) {
    private val events = ArrayList<Pair<Int, Event>>()
    private val seen = FloatArray(NUMBERS.size) { NUMBERS[it].get(Look()) }
    private var held = 0

    /** How many updates there were. */
    var updates: Int = 0
        private set

    /** Before an update: which of the driving keys [window] reports. */
    fun update(window: WindowState) {
        look()
        var now = 0
        for (i in KEYS.indices) if (window.getKeyState(KEYS[i])) now = now or (1 shl i)
        if (now != held) add(Event.Hold(LETTERS.filterIndexed { i, _ -> now and (1 shl i) != 0 }))
        held = now
        updates++
    }

    fun mouse(x: Double): Unit = add(Event.Mouse(x))

    fun press(key: Int): Unit = add(Event.Press(key))

    fun turn(
        name: String,
        value: Float,
    ): Unit = add(Event.Turn(name, value))

    fun reset(): Unit = add(Event.Reset)

    /** The picture that is drawn was saved. */
    fun picture() {
        look()
        add(Event.Picture)
    }

    /** Whether something was left out for want of room. */
    var isFull: Boolean = false
        private set

    /** Everything so far. */
    fun recording(): Recording {
        look()
        return Recording(step, events.toList(), updates)
    }

    private fun look() {
        for (i in NUMBERS.indices) {
            val value = NUMBERS[i].get(look)
            if (value == seen[i]) continue
            seen[i] = value
            turn(NUMBERS[i].word, value)
        }
    }

    private fun add(event: Event) {
        isFull = events.size >= MAX_EVENTS
        if (!isFull) events += updates to event
    }

    internal companion object {
        const val LETTERS: String = "WASD"
        val KEYS: IntArray = intArrayOf(GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D)
        private val NUMBERS = LookNumber.entries

        /** Two hours of a mouse that never stands still. */
        const val MAX_EVENTS: Int = 1_000_000
    }
}

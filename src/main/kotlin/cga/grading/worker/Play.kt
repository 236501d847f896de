package cga.grading.worker

import cga.grading.capture.Cursor
import cga.grading.capture.Key
import cga.grading.capture.Moment
import org.lwjgl.glfw.GLFW.*

/** What happens to the game next. */
internal sealed interface Act {
    /** Update number [number], counted from 1. */
    class Update(val number: Long) : Act

    /** [key] goes down or up. */
    class Press(
        val key: Int,
        val isDown: Boolean,
        val modifiers: Int,
    ) : Act

    class Move(val cursor: Cursor) : Act

    class Render(val moment: Moment) : Act
}

/** The script as it is played to a game that updates [frequency] times a second. */
internal object Play {
    /** Where the cursor is before the first event: a game that asks at its start sees no jump at that event. */
    val start: Cursor = Moment.entries.firstNotNullOf { it.mouse }

    fun acts(frequency: Double): Iterator<Act> =
        iterator {
            var held = emptySet<Key>()
            var seconds = 0.0
            var updates = 0L
            for (moment in Moment.entries) {
                for (key in held - moment.keys) yield(press(key, false, moment.keys))
                for (key in moment.keys - held) yield(press(key, true, moment.keys))
                held = moment.keys
                moment.mouse?.let { yield(Act.Move(it)) }
                seconds += moment.seconds
                // Of the whole time, so that moments shorter than an update do not get lost.
                val due = Math.round(seconds * frequency)
                while (updates < due) yield(Act.Update(++updates))
                yield(Act.Render(moment))
            }
            for (key in held) yield(press(key, false, emptySet()))
        }

    private fun press(
        key: Key,
        isDown: Boolean,
        held: Set<Key>,
    ) = Act.Press(code(key), isDown, if (Key.LEFT_ALT in held) GLFW_MOD_ALT else 0)

    private fun code(key: Key): Int =
        when (key) {
            Key.FORWARD -> GLFW_KEY_W
            Key.BACK -> GLFW_KEY_S
            Key.LEFT -> GLFW_KEY_A
            Key.RIGHT -> GLFW_KEY_D
            Key.LEFT_ALT -> GLFW_KEY_LEFT_ALT
        }
}

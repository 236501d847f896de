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

    /** What happens [frequency] times a second; [asked] are the keys that the game has asked for up to then. */
    fun acts(
        frequency: Double,
        asked: Set<Int> = emptySet(),
    ): Iterator<Act> =
        iterator {
            // When the first of them goes down, the game has long been asking.
            val keys by lazy { if (GLFW_KEY_W !in asked && GLFW_KEY_UP in asked) ARROWS else LETTERS }

            fun press(
                key: Key,
                isDown: Boolean,
                held: Set<Key>,
            ) = Act.Press(
                if (key ==
                    Key.LEFT_ALT
                ) {
                    GLFW_KEY_LEFT_ALT
                } else {
                    keys.getValue(key)
                },
                isDown,
                if (Key.LEFT_ALT in held) GLFW_MOD_ALT else 0,
            )

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

    /** The keys of the sheet; instead of them the [ARROWS] are pressed where a game asks for those only. */
    private val LETTERS = mapOf(Key.FORWARD to GLFW_KEY_W, Key.BACK to GLFW_KEY_S, Key.LEFT to GLFW_KEY_A, Key.RIGHT to GLFW_KEY_D)
    private val ARROWS =
        mapOf(Key.FORWARD to GLFW_KEY_UP, Key.BACK to GLFW_KEY_DOWN, Key.LEFT to GLFW_KEY_LEFT, Key.RIGHT to GLFW_KEY_RIGHT)
}

package cga.inspect.record

import cga.exercise.game.Step
import cga.framework.AtomicFile
import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Path
import kotlin.io.path.writeText

/** Something that happened to the scene after so many of its updates. */
public sealed interface Event {
    /** From the next update on exactly the [keys] (letters of W, A, S, D) are held down. */
    public data class Hold(val keys: String) : Event

    /** The mouse is at [x]. */
    public data class Mouse(val x: Double) : Event

    /** The key with this GLFW number was pressed. */
    public data class Press(val key: Int) : Event

    /** A screenshot was taken. */
    public data object Picture : Event
}

/**
 * All input of a run: played again it makes the same pictures, since nothing else decides them.
 *
 * As a file it is text: a line says after which update what happened, as in `12 hold WA`, `40 mouse 123.5`, `51 press 52`, `90 picture`; the last one
 * is `300 end`.
 *
 * @param step that the scene started with.
 * @param events each with the number of updates before it, in order.
 * @param updates in all, 1/120 s each.
 */
public class Recording(
    public val step: Step,
    public val events: List<Pair<Int, Event>>,
    public val updates: Int,
) {
    /** The updates after which screenshots were taken. */
    public val pictures: List<Int> get() = events.filter { it.second == Event.Picture }.map { it.first }

    /** Writes it to [file]. Throws [InputError]. */
    public fun write(file: Path): Unit = AtomicFile.write(file) { it.writeText(toText()) }

    internal fun toText(): String =
        buildString {
            appendLine("$FIRST_LINE ${step.sheet}")
            for ((update, event) in events) appendLine("$update ${words(event)}")
            appendLine("$updates end")
        }

    private fun words(event: Event) =
        when (event) {
            is Event.Hold -> "hold ${event.keys.ifEmpty { NOTHING }}"
            is Event.Mouse -> "mouse ${event.x}"
            is Event.Press -> "press ${event.key}"
            Event.Picture -> "picture"
        }

    public companion object {
        private const val FIRST_LINE = "cga recording 1, step"
        private const val NOTHING = "-"

        /** Ten hours; and more events than anybody makes in them. */
        private const val MAX_UPDATES = 120 * 3600 * 10
        private const val MAX_BYTES = 64_000_000
        private val LINE =
            Regex("""(\d{1,8}) (?:hold (-|[WASD]{1,4})|mouse (-?\d{1,12}(?:\.\d+)?(?:E-?\d{1,2})?)|press (\d{1,3})|(picture)|(end))""")

        /** Reads the recording in [file]. Throws [InputError] naming the file, and the line that is not understood. */
        public fun read(file: Path): Recording {
            val bytes = Home.read(file.toAbsolutePath(), "recording")
            if (bytes.size > MAX_BYTES) throw InputError("recording $file is larger than $MAX_BYTES bytes: record less.")
            return parse(bytes.decodeToString(), "$file")
        }

        internal fun parse(
            text: String,
            name: String,
        ): Recording {
            val lines = text.trimEnd().lines()
            val step = lines[0].removePrefix("$FIRST_LINE ").takeIf { it != lines[0] }?.let(Step::of)
            if (step == null) throw InputError("recording $name does not begin with \"$FIRST_LINE …\": F9 in the window makes recordings.")
            val events = ArrayList<Pair<Int, Event>>()
            var last = 0
            for ((i, line) in lines.withIndex().drop(1)) {
                val words = LINE.matchEntire(line)?.groupValues
                val update = words?.get(1)?.toInt()
                if (words == null || update == null || update < last || update > MAX_UPDATES) throw notUnderstood(name, i, line)
                last = update
                if (words[END].isNotEmpty()) {
                    if (i != lines.lastIndex) throw notUnderstood(name, i + 1, lines[i + 1])
                    return Recording(step, events, update)
                }
                events += update to event(words)
            }
            throw InputError("recording $name has no line \"… end\": it is not whole, record it again.")
        }

        private const val END = 6

        private fun event(words: List<String>): Event {
            val (hold, mouse, press) = words.drop(2)
            return when {
                hold.isNotEmpty() -> Event.Hold(hold.removePrefix(NOTHING))
                mouse.isNotEmpty() -> Event.Mouse(mouse.toDouble())
                press.isNotEmpty() -> Event.Press(press.toInt())
                else -> Event.Picture
            }
        }

        private fun notUnderstood(
            name: String,
            line: Int,
            text: String,
        ) = InputError("recording $name, line ${line + 1}: cannot read \"${text.take(80)}\". F9 in the window makes recordings.")
    }
}

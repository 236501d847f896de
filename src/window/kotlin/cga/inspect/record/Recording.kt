package cga.inspect.record

import cga.exercise.game.Step
import cga.framework.AtomicFile
import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Path
import kotlin.io.path.writeText

/**
 * All input of a run, by keys, mouse and panel: played again it makes the same pictures, since nothing else decides them.
 *
 * As a file it is text: a line says after which update what happened, as in `12 hold WA`, `40 mouse 123.5`, `51 press 52`,
 * `60 turn view 4.0`, `70 turn spotLight.inner 12.5`, `80 reset`, `90 picture`; the last one is `300 end`.
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
            is Event.Turn -> "turn ${event.name} ${event.value}"
            Event.Reset -> "reset"
            Event.Picture -> "picture"
        }

    public companion object {
        private const val FORMAT = "cga recording"
        private const val FIRST_LINE = "$FORMAT 2, step"
        private const val NOTHING = "-"

        /** Ten hours; and more events than anybody makes in them. */
        private const val MAX_UPDATES = 120 * 3600 * 10
        private const val MAX_BYTES = 64_000_000
        private const val NUMBER = """(-?\d{1,12}(?:\.\d+)?(?:E-?\d{1,2})?)"""
        private val LINE =
            Regex(
                """(\d{1,8}) (?:hold (-|[WASD]{1,4})|mouse $NUMBER|press (\d{1,3})|""" +
                    """turn ([A-Za-z0-9_.]{1,40}) $NUMBER|(reset)|(picture)|(end))""",
            )

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
            if (step == null) throw notBegun(name, lines[0])
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

        private const val END = 9

        private fun event(words: List<String>): Event {
            val (hold, mouse, press, name, value) = words.drop(2)
            return when {
                hold.isNotEmpty() -> Event.Hold(hold.removePrefix(NOTHING))
                mouse.isNotEmpty() -> Event.Mouse(mouse.toDouble())
                press.isNotEmpty() -> Event.Press(press.toInt())
                name.isNotEmpty() -> Event.Turn(name, value.toFloat())
                words[RESET].isNotEmpty() -> Event.Reset
                else -> Event.Picture
            }
        }

        private const val RESET = 7

        private fun notBegun(
            name: String,
            line: String,
        ): InputError {
            val other = Regex("$FORMAT (\\d+), .*").matchEntire(line)?.groupValues?.get(1)
            return InputError(
                if (other != null && !line.startsWith(FIRST_LINE)) {
                    "recording $name has format $other, and this program plays format 2 only: record it again."
                } else {
                    "recording $name does not begin with \"$FIRST_LINE …\": F9 in the window makes recordings."
                },
            )
        }

        private fun notUnderstood(
            name: String,
            line: Int,
            text: String,
        ) = InputError("recording $name, line ${line + 1}: cannot read \"${text.take(80)}\". F9 in the window makes recordings.")
    }
}

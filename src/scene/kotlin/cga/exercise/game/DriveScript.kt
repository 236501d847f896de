package cga.exercise.game

import cga.framework.InputError
import org.lwjgl.glfw.GLFW.*

/**
 * Keys held down over time, for driving without a keyboard: `W 2, WA 0.5` holds W for two seconds, then W and A for half a second.
 *
 * A part without letters (`1.5`) holds nothing.
 */
public class DriveScript private constructor(private val parts: List<Part>) {
    private class Part(
        val keys: Set<Int>,
        val end: Double,
    )

    /** Length in seconds. */
    public val duration: Double = parts.lastOrNull()?.end ?: 0.0

    /** Whether [key] (a `GLFW_KEY_…` constant) is held [time] seconds after the start. */
    public fun isDown(
        key: Int,
        time: Double,
    ): Boolean = parts.firstOrNull { time < it.end }?.keys?.contains(key) ?: false

    public companion object {
        /** Hands off. */
        public val NONE: DriveScript = DriveScript(emptyList())

        private const val MAX_SECONDS = 3600.0
        private val PART = Regex("""([WASD]*)\s*(\d{1,9}(?:\.\d+)?)""", RegexOption.IGNORE_CASE)
        private val KEYS = mapOf('W' to GLFW_KEY_W, 'A' to GLFW_KEY_A, 'S' to GLFW_KEY_S, 'D' to GLFW_KEY_D)

        /** Reads a script as described above, an hour at most. Throws [InputError] naming the part that is not understood. */
        public fun parse(text: String): DriveScript {
            var end = 0.0
            val parts =
                text.split(',').map { part ->
                    val (letters, seconds) = PART.matchEntire(part.trim())?.destructured ?: throw notUnderstood(part)
                    end += seconds.toDouble()
                    Part(letters.uppercase().map(KEYS::getValue).toSet(), end)
                }
            if (end > MAX_SECONDS) throw InputError("drive script: $end seconds are too long, $MAX_SECONDS are the most.")
            return DriveScript(parts)
        }

        private fun notUnderstood(part: String) =
            InputError("drive script: cannot read \"${part.trim()}\". Write keys and seconds, as in \"W 2, WA 0.5\".")
    }
}

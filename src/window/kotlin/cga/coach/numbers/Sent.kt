package cga.coach.numbers

/**
 * A uniform of one to four floats that a program sends, and what the window makes of it on the way.
 *
 * @param name as OpenGL calls it.
 * @param size how many floats.
 */
internal class Sent(
    val name: String,
    val size: Int,
) {
    /** What the program sent last. */
    val values: FloatArray = FloatArray(size)

    /** Whether it has sent other values within the same picture. */
    var varies: Boolean = false

    /** What everything sent is multiplied by. */
    var scale: Float = 1f
    private val held = FloatArray(size) { Float.NaN }

    /** The largest number that has been seen, at least 1. */
    var largest: Float = 1f
        private set

    /** Whether a number below 0 has been seen. */
    var hasNegative: Boolean = false
        private set
    internal var picture = -1L

    /** The number [component] as the shaders get it. */
    fun value(component: Int): Float = if (held[component].isNaN()) values[component] * scale else held[component]

    /** Whether anything is other than the program sends it. */
    val isChanged: Boolean get() = scale != 1f || held.any { !it.isNaN() }

    /** Puts [value] in the place of whatever the program sends as [component]. */
    fun hold(
        component: Int,
        value: Float,
    ) {
        held[component] = value
    }

    /** What the program sends is sent again. */
    fun release() {
        held.fill(Float.NaN)
        scale = 1f
    }

    /** The program sends [value] as [component], in picture number [now]. */
    fun note(
        component: Int,
        value: Float,
        now: Long,
    ) {
        if (picture == now && values[component] != value) varies = true
        values[component] = value
        if (!value.isFinite()) return
        largest = maxOf(largest, kotlin.math.abs(value))
        hasNegative = hasNegative || value < 0
    }
}

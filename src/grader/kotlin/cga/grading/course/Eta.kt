package cga.grading.course

import kotlin.math.ceil
import kotlin.math.max
import kotlin.math.sqrt

/**
 * How long the rest takes, from the submissions that were graded in this run: those taken over from an earlier one took no time and say
 * nothing. Given as a range, because the times differ: a submission that loops takes ten times as long as one that works.
 *
 * Of n times with mean m and variance s², r further ones on j workers take r·m/j, give or take two standard deviations of that prediction:
 * √(r·s²·(1 + r/n))/j; and never less than what is left of the longest that may be running.
 */
public class Eta(
    private val jobs: Int,
) {
    private val times = mutableListOf<Double>()

    /** One more took [seconds]. */
    public fun add(seconds: Double) {
        times += seconds
    }

    /** Seconds that [remaining] submissions will take, at least and at most; null while too few are known to say. */
    public fun seconds(remaining: Int): ClosedFloatingPointRange<Double>? {
        if (remaining == 0) return 0.0..0.0
        val n = times.size
        if (n < LEAST) return null
        val mean = times.average()
        val variance = times.sumOf { (it - mean) * (it - mean) } / (n - 1)
        val workers = minOf(jobs, remaining)
        val expected = remaining * mean / workers
        val spread = 2 * sqrt(remaining * variance * (1 + remaining.toDouble() / n)) / workers
        return max(0.0, expected - spread)..expected + spread
    }

    /** The same in words: "4–6 min left". */
    public fun words(remaining: Int): String {
        val range = seconds(remaining) ?: return "time left not known yet"
        val unit = UNITS.last { it.seconds == 1.0 || range.endInclusive >= 2 * it.seconds }
        val (least, most) = ceil(range.start / unit.seconds).toInt() to ceil(range.endInclusive / unit.seconds).toInt()
        return (if (least == most) "$most" else "$least–$most") + " ${unit.name} left"
    }

    private class Unit(
        val name: String,
        val seconds: Double,
    )

    private companion object {
        /** Fewer say nothing about how the times differ. */
        const val LEAST = 3
        val UNITS = listOf(Unit("s", 1.0), Unit("min", 60.0), Unit("h", 3600.0))
    }
}

package cga.grading.report

import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/**
 * Where values stand on an axis from [start] to [end], in units of the drawing.
 *
 * @param ticks round values within, at even distances.
 */
internal class Axis private constructor(
    private val low: Double,
    private val high: Double,
    private val start: Int,
    private val end: Int,
    val ticks: List<Double>,
) {
    /** The place of [value]. */
    fun at(value: Double): Double = start + (value - low) / (high - low) * (end - start)

    companion object {
        private const val MOST_TICKS = 6
        private const val MOST_RANGE = 1e300

        /** An axis that holds all of [values] between round ends. What does not change gets room above and below. */
        fun over(values: List<Double>, start: Int, end: Int): Axis {
            val (least, most) = values.min().coerceIn(-MOST_RANGE, MOST_RANGE) to values.max().coerceIn(-MOST_RANGE, MOST_RANGE)
            val room = if (most > least) 0.0 else maxOf(1.0, kotlin.math.abs(most) / 2)
            val step = step(most - least + 2 * room)
            val (low, high) = floor((least - room) / step) * step to ceil((most + room) / step) * step
            // By numbers of steps: sums of steps would gather rounding.
            val ticks = (0..((high - low) / step + 0.5).toInt()).map { (floor(low / step + 0.5) + it) * step }
            return Axis(low, high, start, end, ticks)
        }

        /** 1, 2 or 5 times a power of ten, at most [MOST_TICKS] of which are [range]. */
        private fun step(range: Double): Double {
            val decade = 10.0.pow(floor(log10(range / MOST_TICKS)))
            return listOf(1, 2, 5, 10).map { it * decade }.first { it * MOST_TICKS >= range * (1 - 1e-9) }
        }
    }
}

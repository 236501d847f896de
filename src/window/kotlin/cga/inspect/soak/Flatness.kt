package cga.inspect.soak

import kotlin.math.max

/**
 * Whether what was held stays the same.
 *
 * Of the [Held]s, all taken after everything was used once, the first third is left out: there compilers and caches still fill. Over the
 * others the [Trend] of each figure is found. It grew where even the least slope that the figures allow makes more, over the time looked
 * at, than the allowance: so noise, a single jump, and a warm-up that ends within the first half of the looks are no growth; a leak is, as
 * soon as it has made more than the allowance. Resident memory can be judged only where the heap is as large at the start as it ever gets,
 * as `./cga soak` has it: else it grows with the heap that fills for the first time.
 */
public object Flatness {
    /** So much may come over the time looked at: what allocators and drivers keep for later. MiB. */
    public const val RESIDENT: Double = 8.0

    /** The same of the heap after a collection. MiB. */
    public const val LIVE: Double = 2.0

    /** Half an object is none. */
    private const val OBJECTS = 0.5
    private const val FEWEST = 9
    private const val MINUTE = 60.0

    private class Figure(
        val name: String,
        val unit: String,
        val allowed: Double,
        val of: (Held) -> Double,
    )

    private val FIGURES =
        listOf(
            Figure("resident memory", "MiB", RESIDENT) { it.resident },
            Figure("live heap", "MiB", LIVE) { it.live },
            Figure("OpenGL objects", "objects", OBJECTS) { it.glObjects.toDouble() },
        )

    /** What grew, in words; empty where nothing did. */
    public fun growth(looks: List<Held>): List<String> {
        if (looks.size < FEWEST) return listOf("too few looks to tell: ${looks.size}, and $FEWEST are the fewest")
        return FIGURES.filter { trend(looks, it).low * span(looks) > it.allowed }.map { "${it.name} grew: ${words(looks, it)}" }
    }

    /** The slope of each figure and how sure it is. */
    public fun slopes(looks: List<Held>): List<String> = FIGURES.map { "${it.name}: ${words(looks, it)}" }

    private fun judged(looks: List<Held>) = looks.drop(looks.size / 3)

    private fun span(looks: List<Held>) = judged(looks).run { last().seconds - first().seconds }

    private fun trend(
        looks: List<Held>,
        figure: Figure,
    ): Trend {
        val judged = judged(looks)
        return Trend.of(DoubleArray(judged.size) { judged[it].seconds }, DoubleArray(judged.size) { figure.of(judged[it]) })
    }

    private fun words(
        looks: List<Held>,
        figure: Figure,
    ): String {
        val trend = trend(looks, figure)
        val off = max(trend.high - trend.slope, trend.slope - trend.low) * MINUTE
        return "%.2f ± %.2f %s a minute".format(trend.slope * MINUTE, off, figure.unit)
    }
}

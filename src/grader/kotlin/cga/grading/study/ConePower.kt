package cga.grading.study

import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.pow

/** A cone whose falloff is a power of what is linear in the cosine: its factor applied twice, or cos(θ)ⁿ. */
internal object ConePower {
    /** The shape of [values] between [low] and [high] over [cosines]; null where no power is straight. */
    fun of(
        cosines: List<Double>,
        values: List<Double>,
        low: Double,
        high: Double,
    ): ConeShape? {
        val shares = values.map { ((it - low) / (high - low)).coerceIn(0.0, 1.0) }
        val power = straightest(cosines, shares)
        val roots = shares.map { it.pow(1 / power) }
        val (slope, offset) = ConeShape.line(cosines, roots) ?: return null
        if (!(misfit(cosines, shares, power) < ConeShape.STRAIGHT)) return null
        val error = shares.indices.maxOf { abs(roots[it] - shares[it]) }
        return ConeShape((1 - offset) / slope, -offset / slope, high, Falloff.POWER, error, residual = 0.0)
    }

    /** The exponent of which [shares] leave least, looked for in ever smaller steps. */
    private fun straightest(
        cosines: List<Double>,
        shares: List<Double>,
    ): Double {
        var from = ln(LEAST)
        var to = ln(MOST)
        repeat(ROUNDS) {
            val steps = List(STEPS + 1) { from + (to - from) * it / STEPS }
            val best = steps.minBy { misfit(cosines, shares, exp(it)) }
            val step = (to - from) / STEPS
            from = best - step
            to = best + step
        }
        return exp((from + to) / 2)
    }

    /** The largest distance of the roots from a line, relative to their range: all high roots are near 1. */
    private fun misfit(
        cosines: List<Double>,
        shares: List<Double>,
        power: Double,
    ): Double {
        val roots = shares.map { it.pow(1 / power) }
        val (slope, offset) = ConeShape.line(cosines, roots) ?: return Double.MAX_VALUE
        return roots.indices.maxOf { abs(slope * cosines[it] + offset - roots[it]) } / (roots.max() - roots.min())
    }

    private const val LEAST = 0.2
    private const val MOST = 130.0
    private const val STEPS = 24
    private const val ROUNDS = 6
}

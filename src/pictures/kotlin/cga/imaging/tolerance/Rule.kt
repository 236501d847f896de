package cga.imaging.tolerance

import cga.imaging.Comparison
import cga.imaging.Severity

/** A node of a tolerance's tree. */
internal sealed interface Rule {
    fun judge(comparison: Comparison): Verdict
}

/** As severe as the most severe of [rules]; those after a failure are not asked. */
internal class All(private val rules: List<Rule>) : Rule {
    override fun judge(comparison: Comparison): Verdict {
        val verdicts = mutableListOf<Verdict>()
        for (rule in rules) {
            verdicts += rule.judge(comparison)
            if (verdicts.last().severity == Severity.FAIL) break
        }
        val severity = verdicts.maxOf { it.severity }
        return Verdict(severity, verdicts.sortedByDescending { it.severity }.flatMap { it.messages })
    }
}

/** As severe as the least severe of [rules]; those after a pass are not asked. */
internal class AnyOf(private val rules: List<Rule>) : Rule {
    override fun judge(comparison: Comparison): Verdict {
        val verdicts = mutableListOf<Verdict>()
        for (rule in rules) {
            verdicts += rule.judge(comparison)
            if (verdicts.last().severity == Severity.PASS) return Verdict.PASS
        }
        val severity = verdicts.minOf { it.severity }
        return Verdict(severity, verdicts.filter { it.severity == severity }.flatMap { it.messages })
    }
}

/**
 * A leaf: one [metric] and how far it may go.
 *
 * @param warn beyond it the verdict is a warning, and beyond [fail] a failure; null for never.
 * @param reason why the bound is what it is.
 * @param machine where that was measured.
 */
internal class Bound(
    private val metric: Metric,
    private val warn: Double?,
    private val fail: Double?,
    private val reason: String,
    private val machine: String,
) : Rule {
    override fun judge(comparison: Comparison): Verdict {
        val value = metric.measure(comparison)
        return when {
            isBeyond(value, fail) -> Verdict(Severity.FAIL, listOf(message(value, fail, comparison)))
            isBeyond(value, warn) -> Verdict(Severity.WARN, listOf(message(value, warn, comparison)))
            else -> Verdict.PASS
        }
    }

    /** Values such as 2/255 come from different divisions: [SLACK] is 10⁷ roundings of a double, and far below one of a float. */
    private fun isBeyond(
        value: Double,
        bound: Double?,
    ): Boolean =
        when {
            bound == null -> false
            // No metric gives NaN, but if one did, that would be no pass.
            value.isNaN() -> true
            metric.higherIsBetter -> value < bound * (1 - SLACK)
            else -> value > bound * (1 + SLACK)
        }

    private fun message(
        value: Double,
        bound: Double?,
        comparison: Comparison,
    ): String {
        val side = if (metric.higherIsBetter) "below the least" else "over the"
        val (found, allowed) = listOf(value, bound ?: value).map { metric.format(it, comparison) }
        return "${metric.title} $found is $side allowed $allowed, ${metric.place(comparison)} (the bound: $reason; $machine)"
    }

    private companion object {
        const val SLACK = 1e-9
    }
}

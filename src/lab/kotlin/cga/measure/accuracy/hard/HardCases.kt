package cga.measure.accuracy.hard

import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import java.math.MathContext
import java.util.Locale

/** The cases in which obvious arithmetic fails, each measured against double precision: what it costs, and what ours costs. */
public object HardCases {
    /**
     * Measures all cases, in a few seconds. Opens an off-screen context of [context], or of the first kind that works, so none may be
     * current in this process. Throws [cga.framework.context.ContextUnavailable] where there is none.
     */
    public fun measure(context: ContextKind? = null): List<HardCase> =
        OffscreenContext.open(context).use {
            Probe().use { probe ->
                ConeCases(probe).measure() + EdgeCases(probe).measure() + TransformCases.measure() + DistanceCases(probe).measure() +
                    GroundCases.measure() + DepthCases.measure() + TimeCases.measure()
            }
        }

    /** [cases] as a table in Markdown. */
    public fun table(cases: List<HardCase> = measure()): String =
        (listOf(HEADER, RULE) + cases.map(::row)).joinToString("\n", postfix = "\n")

    /**
     * Shades [evaluations] random points, many of them at the limits of the domain, and looks for pixels that are not finite or further
     * from the truth than floats explain. The same [seed] gives the same points. A context is opened as by [measure].
     */
    public fun search(
        evaluations: Int,
        seed: Long,
        context: ContextKind? = null,
    ): SearchResult = OffscreenContext.open(context).use { Probe().use { Search(it, seed).run(evaluations) } }

    private fun row(case: HardCase): String =
        with(case) {
            val cells = listOf(name, naive, number(naiveError), ours, number(ourError), number(bound), unit.label, failure.ifEmpty { "–" })
            cells.joinToString(" | ", "| ", " |") { it.replace("|", "\\|") }
        }

    private fun number(value: Double): String =
        when {
            value.isNaN() || value.isInfinite() -> "NaN"
            value == 0.0 -> "0"
            value < 1e-3 || value >= 1e6 -> "%.1e".format(Locale.ROOT, value)
            else -> value.toBigDecimal().round(MathContext(2 + (if (value >= 100) 1 else 0))).stripTrailingZeros().toPlainString()
        }

    private const val HEADER = "| case | naive form | its error | our form | our error | bound | unit | where the naive form fails |"
    private const val RULE = "|---|---|---:|---|---:|---:|---|---|"
}

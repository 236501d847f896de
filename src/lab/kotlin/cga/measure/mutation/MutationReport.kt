package cga.measure.mutation

import cga.imaging.Severity
import java.util.Locale

/** The figures of a mutation run over [cases] cases as Markdown, and as CSV with every case. */
public class MutationReport(
    private val mutants: List<MutantResult>,
    private val renderers: List<RendererResult>,
    private val cases: Int,
) {
    private val visible = mutants.filter { it.visibleIn > 0 }
    private val sound = renderers.filter { it.renderer.mustPass }

    /** Visible defects that not even the exact tier finds, and sound renderers that the tolerant tier refuses; none is good. */
    public val failures: List<String>
        get() =
            mutants.flatMap { result -> hidden(result).map { "\"${result.mutant.name}\" is visible and not found in ${it.case}" } } +
                sound.filter { it.verdict == Severity.FAIL }.map { "\"${it.renderer.title}\" draws nothing wrong and fails" }

    /** The tables, as they stand in the documentation. */
    public fun markdown(): String =
        buildString {
            if (mutants.isNotEmpty()) appendLine(summary()).appendLine()
            for ((part, results) in mutants.groupBy { it.mutant.part }) {
                appendLine("| ${part.title} | visible | exact | tolerant | $FIGURES |")
                appendLine("|---|---:|---:|---:|---:|---:|---:|---:|")
                for (it in results) {
                    appendLine(
                        "| ${it.mutant.name} | ${it.visibleIn} | ${it.failsExactIn} | ${found(it)} | ${worst(it.cases)} |",
                    )
                }
                appendLine()
            }
            if (renderers.isNotEmpty()) {
                appendLine("| renderer | differs in | tolerant | $FIGURES |")
                appendLine("|---|---:|---|---:|---:|---:|---:|")
                for (it in renderers) {
                    val differing = it.cases.count { case -> !case.isIdentical }
                    appendLine("| ${it.renderer.title}: ${it.name} | $differing | ${it.verdict.name.lowercase()} | ${worst(it.cases)} |")
                }
                appendLine()
            }
            if (visible.isNotEmpty() && sound.isNotEmpty()) append(separation())
        }

    /** Every figure, a line for each case of each defect and renderer. */
    public fun csv(): String =
        buildString {
            appendLine("kind,name,case,max,differing,window,flip,verdict,visible")
            for (it in mutants) for (case in it.cases) appendLine("defect,\"${it.mutant.name}\",${row(case)}")
            for (it in renderers) for (case in it.cases) appendLine("renderer,\"${it.renderer.title}\",${row(case)}")
        }

    private fun row(case: CaseFigures) =
        listOf(case.case, case.maximum, case.differing, case.window, case.flipMean, case.verdict.name.lowercase(), case.visiblePixels)
            .joinToString(",")

    private fun hidden(result: MutantResult) = result.cases.filter { it.isVisible && it.isIdentical }

    private fun summary(): String {
        val missed = visible.filter { it.failsTolerantIn == 0 }.joinToString { "*${it.mutant.name}*" }
        val exact = visible.count { it.failsExactIn > 0 }
        val tolerant = visible.count { it.failsTolerantIn > 0 }
        return "${mutants.size} defects, ${visible.size} of them visible in at least one of the $cases cases. " +
            "Of those the exact tier finds $exact, the tolerant tier $tolerant" + if (missed.isEmpty()) "." else "; it misses $missed."
    }

    /** How far apart those are that a bound has to stand between. Float pictures have bounds of their own. */
    private fun separation() =
        buildString {
            val (found, missed) = visible.partition { result -> result.cases.any { !it.case.float && it.verdict == Severity.FAIL } }

            fun row(
                title: String,
                results: List<List<CaseFigures>>,
                choose: (Iterable<Double>) -> Double,
            ) {
                if (results.isNotEmpty()) appendLine("| $title | ${format { figure -> choose(results.map { worst(it, figure) }) }} |")
            }
            appendLine("| 8-bit cases | $FIGURES |")
            appendLine("|---|---:|---:|---:|---:|")
            row("largest of a renderer that must pass", sound.map { it.cases }) { it.max() }
            row("largest of a visible defect that is missed", missed.map { it.cases }) { it.max() }
            row("smallest of a visible defect that is found", found.map { it.cases }) { it.min() }
        }

    private fun found(result: MutantResult) =
        when {
            result.failsTolerantIn > 0 -> "${result.failsTolerantIn}"
            result.visibleIn > 0 -> "**missed**"
            else -> "0"
        }

    private fun worst(cases: List<CaseFigures>) = format { worst(cases, it) }

    private fun worst(
        cases: List<CaseFigures>,
        figure: (CaseFigures) -> Double,
    ) = cases.filter { !it.case.float }.maxOf(figure)

    private fun format(number: ((CaseFigures) -> Double) -> Double): String =
        listOf(
            "%.0f".format(Locale.ROOT, number { it.maximum }),
            "%.3f %%".format(Locale.ROOT, 100 * number { it.differing }),
            "%.3f".format(Locale.ROOT, number { it.window }),
            "%.5f".format(Locale.ROOT, number { it.flipMean }),
        ).joinToString(" | ")

    private companion object {
        const val FIGURES = "max, 1/255 | differing | worst 16×16, 1/255 | ꟻLIP mean"

        val RendererResult.verdict: Severity get() = cases.maxOf { it.verdict }
    }
}

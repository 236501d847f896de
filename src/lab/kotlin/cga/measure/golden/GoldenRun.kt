package cga.measure.golden

import cga.framework.Home
import cga.framework.InputError
import cga.imaging.Severity
import cga.imaging.golden.GoldenJudge
import cga.imaging.golden.GoldenStore
import cga.imaging.golden.Outcome
import cga.imaging.golden.Rendered
import cga.imaging.report.ReportCase
import cga.imaging.tolerance.ToleranceTiers

/** What became of one case; [rendered] is null where the case could not be drawn, or where there is a golden and no case. */
public class GoldenResult(
    public val name: String,
    public val outcome: Outcome,
    public val rendered: Rendered?,
) {
    /** As a case of a report. */
    public fun reportCase(): ReportCase {
        val origin = rendered?.origin
        val machine = origin?.let { "renderer" to "${it.machine.renderer}, ${it.machine.driver}" }
        val facts = origin?.made.orEmpty().toList() + listOfNotNull(machine)
        return ReportCase(name, outcome.severity, outcome.messages, outcome.comparison, facts, rendered?.picture)
    }
}

/** Renders cases and compares them with the goldens in `tests/golden`. */
public class GoldenRun(
    private val renderer: GoldenRenderer = GoldenRenderer(),
    private val isCi: Boolean = isCi(),
) {
    /** The goldens. */
    public val store: GoldenStore = GoldenStore(Home.resolve(FOLDER))
    private val judge = GoldenJudge(store, ToleranceTiers.read(Home.resolve("$FOLDER/${GoldenStore.TOLERANCE}")))

    /** Draws [case] and judges it. */
    public fun result(case: GoldenCase): GoldenResult =
        try {
            val rendered = renderer.render(case)
            GoldenResult(case.name, strictly(judge.judge(case.name, rendered)), rendered)
        } catch (e: InputError) {
            GoldenResult(case.name, Outcome(Severity.FAIL, listOf("cannot be rendered: ${e.message}")), null)
        }

    /** A failure for each golden of which there is no case. */
    public fun strays(): List<GoldenResult> =
        judge.strays(GoldenCases.all.map { it.name }.toSet()).map { (name, outcome) -> GoldenResult(name, outcome, null) }

    /** In CI, which is there to judge, a skip is a failure. */
    private fun strictly(outcome: Outcome) =
        if (isCi && outcome.isSkipped) Outcome(Severity.FAIL, outcome.messages, outcome.comparison, isSkipped = true) else outcome

    public companion object {
        /** Where the goldens are, from the project's folder. */
        public const val FOLDER: String = "tests/golden"

        /** Whether this is a run of continuous integration, by the variable that all of them set. */
        public fun isCi(): Boolean = !System.getenv("CI").isNullOrEmpty()
    }
}

package cga.grading.report

import cga.grading.findings.Graded
import cga.grading.findings.Outcome
import cga.grading.findings.Part
import cga.grading.findings.Refused
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import java.nio.file.Path

/**
 * One submission, ready to be reported on.
 *
 * @param name as its folder or archive is called.
 * @param folder where its evidence lies and its page goes; its name is plain.
 * @param seconds wall time of the whole.
 * @param twins by the names of other submissions, the parts that are the same there once names and layout are taken away.
 */
public class GradedSubmission(
    public val name: String,
    public val folder: Path,
    public val outcome: Outcome,
    public val rubric: Rubric,
    public val seconds: Double,
    public val twins: Map<String, Set<Part>> = emptyMap(),
) {
    /** Null where it was refused. */
    public val grade: Grade? = (outcome as? Graded)?.let { Grade.of(it.findings, rubric) }

    /** Null where there is nobody to blame but the grader or its machine. */
    public val points: Double? get() = grade?.points ?: if (refusal?.reason?.isItsOwn == true) 0.0 else null

    public val refusal: Refused? get() = outcome as? Refused

    /** The names of other submissions by the parts that are the same there. */
    internal val twinGroups: Map<Set<Part>, List<String>> get() = twins.entries.groupBy({ it.value.toSortedSet() }, { it.key })

    /** The parts that are the same as in another submission. */
    internal val twinParts: Set<Part> get() = twins.values.flatten().toSortedSet()

    /** The parts that are the same as in the solution. */
    internal val solutionParts: Set<Part> get() = outcome.facts.likeness.solution.toSortedSet()

    /** The same, beside others that are like it. */
    internal fun withTwins(twins: Map<String, Set<Part>>): GradedSubmission =
        GradedSubmission(name, folder, outcome, rubric, seconds, twins)

    public companion object {
        /** Name of the page in [folder]. */
        public const val PAGE: String = "report.html"
    }
}

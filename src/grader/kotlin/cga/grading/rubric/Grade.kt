package cga.grading.rubric

import cga.grading.findings.Check
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.findings.Standing
import kotlin.math.floor

/**
 * The points of one submission. What nothing shows to be right earns nothing, and a defect costs once, where it belongs:
 *
 * 1. What the submission does not have earns nothing, unless the analysis has determined that it is there, and only unseen because of a
 *    mistake that is charged elsewhere ([Found.explains]). What was not measured is open: a person looks.
 * 2. A mistake with a name costs the check that it belongs to, by the share of the rubric; the same mistake twice, or two mistakes of one
 *    check, cost it once. Of a mistake that may belong to several, the first of them that is not right is meant.
 * 3. An error within the tolerance earns all points.
 * 4. A larger one costs nothing where it was measured with a mistake in the picture that was charged elsewhere and explains it
 *    ([Found.explains], where the analysis determined it; else by its nature), or draws the same picture as one of this check; else it
 *    costs by its size.
 *
 * [Mistake.UNKNOWN] is no name: it costs nothing and explains what the analysis determined; else the errors speak for themselves.
 */
public class Grade private constructor(
    public val tasks: List<TaskGrade>,
) {
    public val maximum: Double get() = tasks.sumOf { it.maximum }
    public val points: Double get() = tenths(tasks.sumOf { it.points })

    /** Points that a person has yet to give or to refuse. */
    public val open: Double get() = tenths(tasks.sumOf { it.open })

    /** Every check in the sheet's order. */
    public val checks: List<CheckGrade> get() = tasks.flatMap { it.checks }

    public companion object {
        /** The points that [findings] earn by [rubric]. */
        public fun of(findings: Findings, rubric: Rubric): Grade {
            val measured = findings.checks.associateBy { it.check }
            val homes = findings.mistakes.associateWith { home(it, measured, rubric) }
            val grades = Check.entries.map { grade(it, measured[it], homes, rubric) }
            return Grade(grades.groupBy { it.check.task }.map { (task, checks) -> TaskGrade(task, checks) })
        }

        /** The check that [found] costs; null for one that has no name. */
        private fun home(found: Found, measured: Map<Check, Measured>, rubric: Rubric): Check? {
            if (found.mistake == Mistake.UNKNOWN) return null
            val homes = homesOf(found)
            return homes.find { check -> measured[check].isWrong(rubric.rule(check).tolerance) } ?: homes.first()
        }

        private fun Measured?.isWrong(tolerance: Double) = this != null && (standing == Standing.ABSENT || (error ?: 0.0) > tolerance)

        private fun grade(check: Check, measured: Measured?, homes: Map<Found, Check?>, rubric: Rubric): CheckGrade {
            val rule = rubric.rule(check)

            fun result(state: CheckState, share: Double?, cause: Mistake? = null) =
                CheckGrade(
                    check, state, rule.points,
                    share?.let {
                        tenths(
                            it * rule.points,
                        )
                    },
                    measured?.error, cause, measured?.message ?: Message.NONE,
                )
            val own = homes.filterValues { it == check }.keys.map { it.mistake }.maxByOrNull(rubric::cost)
            val others = homes.filterValues { it != check }.keys
            val error = measured?.error
            val isAbsent = measured?.standing == Standing.ABSENT
            val hider = others.find { it.mistake != Mistake.UNKNOWN && it.explains?.contains(check) == true }
            return when {
                own != null -> result(CheckState.MISTAKE, if (isAbsent) 0.0 else 1 - rubric.cost(own), own)
                isAbsent && hider == null -> result(CheckState.NOT_FOUND, 0.0)
                isAbsent -> result(CheckState.EXPLAINED, 1.0, hider?.mistake)
                error == null -> result(CheckState.OPEN, null)
                error <= rule.tolerance -> result(CheckState.RIGHT, 1.0)
                else -> {
                    val cause = others.find { it.disturbs(check) }
                    if (cause != null) result(CheckState.EXPLAINED, 1.0, cause.mistake) else result(CheckState.INEXACT, rule.share(error))
                }
            }
        }

        private fun Found.disturbs(check: Check) =
            alternatives.any { it.check == check } || check in (explains ?: disturbedBy(mistake))

        /** Half a tenth is rounded up; the small addend undoes what binary fractions lack (0.15 is a little less than 0.15). */
        private fun tenths(points: Double) = floor(points * 10 + 0.5 + 1e-9) / 10
    }
}

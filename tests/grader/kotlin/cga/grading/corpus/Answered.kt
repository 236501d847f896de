package cga.grading.corpus

import cga.grading.analysis.Analysis
import cga.grading.capture.CaptureFile
import cga.grading.findings.Mistake
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import java.nio.file.Path

/** How what the grader says of a submission compares with what it should say; the later, the better. */
internal enum class Answer {
    /** A correct submission that loses points or has a mistake named. */
    FALSE_ALARM,

    /** Something else is named, or more than there is. */
    WRONG,

    /** A mistake was neither named nor cost anything. */
    MISSED,

    /** Points are lost without a name for all of the mistakes. */
    UNKNOWN,

    /** Every mistake is named and nothing else is. */
    NAMED,

    /** A correct submission with nothing to complain of. */
    CLEAN,
}

/** What the grader said of [submission]: the mistakes it [named], the ids of the checks that lost points, and the points. */
internal class Answered(
    val submission: Submission,
    val named: List<Mistake>,
    val costs: List<String>,
    val points: Double,
    /** All that it said, for whoever looks into one case. */
    val details: List<String>,
) {
    /** Checks that lost points although none of the mistakes belongs to them. */
    val elsewhere: Set<String> get() = costs.toSet() - submission.expectation.costs

    val answer: Answer
        get() {
            val wanted = submission.expectation.mistakes
            val isFull = costs.isEmpty()
            if (wanted.isEmpty()) return if (named.isEmpty() && isFull) Answer.CLEAN else Answer.FALSE_ALARM
            val strangers = named.filter { name -> name != Mistake.UNKNOWN && wanted.none { name in it } }
            return when {
                strangers.isNotEmpty() -> Answer.WRONG
                wanted.all { set -> named.any { it in set } } -> Answer.NAMED
                !isFull || named.isNotEmpty() -> Answer.UNKNOWN
                else -> Answer.MISSED
            }
        }

    companion object {
        /** The verdict on the capture in [file]. Needs a current context. */
        fun of(submission: Submission, file: Path): Answered {
            val edition = if (submission.edition == Edition.LATER) "2022" else "2021"
            val findings = Analysis(CaptureFile.read(file), edition, folder = null).findings()
            val grade = Grade.of(findings, Rubric.default())
            val costs = grade.checks.filter { check -> check.points.let { it == null || it < check.maximum } }.map { it.check.id }
            val details =
                grade.checks.map {
                    "${it.check.id} ${it.state} ${it.points}/${it.maximum} error ${it.error} cause ${it.cause}: ${it.message}"
                } +
                    findings.mistakes.map {
                        "${it.mistake} fit ${it.fit} difference ${it.difference} at ${it.where} or ${it.alternatives}"
                    } +
                    findings.notes.map { "$it" }
            return Answered(submission, findings.mistakes.map { it.mistake }, costs, grade.points, details)
        }
    }
}

package cga.grading.corpus

import cga.grading.analysis.Analysis
import cga.grading.capture.CaptureFile
import cga.grading.findings.Findings
import cga.grading.findings.Mistake
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import java.nio.file.Path
import kotlin.math.abs

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
    val findings: Findings,
    /** All that it said, for whoever looks into one case. */
    val details: List<String>,
) {
    /** Checks that lost points although none of the mistakes belongs to them. */
    val elsewhere: Set<String> get() = costs.toSet() - submission.expectation.costs

    /** The points that it should have. */
    val wanted: Double get() = ExpectedPoints.of(submission.expectation, Rubric.default())

    /** Whether the line that a rightly named mistake has is one that was edited; null where no line is named. */
    val line: Boolean?
        get() {
            val edits = Corpus.edits(submission)
            val right = findings.mistakes.filter { found -> submission.expectation.mistakes.any { found.mistake in it } }
            val places = right.mapNotNull { it.places.firstOrNull() }
            return if (places.isEmpty()) null else places.all { place -> edits.any { it.isAt(place) } }
        }

    val answer: Answer
        get() {
            val wanted = submission.expectation.mistakes
            if (submission.expectation.points != null) return unfinished()
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

    /** Of work that is not done the points are judged, and that nothing is named that it has no part of. */
    private fun unfinished(): Answer {
        val strangers = named.filter { name -> name !in UNDONE && submission.expectation.mistakes.none { name in it } }
        return when {
            strangers.isNotEmpty() -> Answer.WRONG
            abs(points - wanted) > NEAR -> Answer.UNKNOWN
            else -> Answer.NAMED
        }
    }

    companion object {
        const val NEAR = 5.0

        /** What may be said of everything that is missing. */
        private val UNDONE =
            setOf(
                Mistake.LIGHT_MISSING, Mistake.SPOT_MISSING, Mistake.MORE_LIGHTS_MISSING, Mistake.ORBIT_MISSING,
                Mistake.ATTENUATION_MISSING, Mistake.COLOR_CONSTANT, Mistake.EMISSION_COLOR_IGNORED, Mistake.PHONG_LEFT,
                Mistake.SPECULAR_MISSING, Mistake.DIFFUSE_MISSING, Mistake.UNKNOWN,
            )

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
            return Answered(submission, findings.mistakes.map { it.mistake }, costs, grade.points, findings, details)
        }
    }
}

package cga.grading.corpus

import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.grading.analysis.Analysis
import cga.grading.capture.CaptureFile
import cga.grading.findings.Mistake
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import java.nio.file.Path

/** How what the grader says of a submission compares with what it should say. */
internal enum class Answer {
    /** Every mistake is named and nothing else is. */
    NAMED,

    /** Something else is named, or more than there is. */
    WRONG,

    /** Points are lost without a name for all of the mistakes. */
    UNKNOWN,

    /** A mistake was neither named nor cost anything. */
    MISSED,

    /** A correct submission with nothing to complain of. */
    CLEAN,

    /** A correct submission that loses points or has a mistake named. */
    FALSE_ALARM,
}

/** What the grader said of [submission]: its mistakes, the checks that cost points and the points. */
internal class Answered(
    val submission: Submission,
    val named: List<Mistake>,
    val costs: List<String>,
    val points: Double,
    val notes: List<String>,
    val lines: List<String> = emptyList(),
) {
    /** Checks that lost points although none of the mistakes belongs to them. */
    val elsewhere: List<String> get() = costs.filter { it.substringBefore('=') !in submission.expectation.costs }

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
            val costs = grade.checks
                .filter {
                    it.points.let { points ->
                        points == null || points < it.maximum
                    }
                }.map { "${it.check.id}=${it.error}" }
            val lines =
                grade.checks.map {
                    "${it.check.id} ${it.state} ${it.points}/${it.maximum} error ${it.error} cause ${it.cause}: ${it.text}"
                } +
                    findings.mistakes.map {
                        "! ${it.mistake} fit ${it.fit} difference ${it.difference} at ${it.where} or ${it.alternatives}"
                    } +
                    findings.notes.map { "note $it" }
            return Answered(submission, findings.mistakes.map { it.mistake }, costs, grade.points, findings.notes, lines)
        }
    }
}

/** Judges part i of n (`i/n`, second argument) of the corpus, or the names that follow, by captures in the folder of the first argument. */
internal object Confusion {
    @JvmStatic
    fun main(args: Array<String>) {
        val (part, parts) = args[1].split('/').map { it.toInt() }
        val chosen = if (args.size == 2) Corpus.mistaken + Corpus.correct else args.drop(2).map(Corpus::byName)
        val captures = CorpusCaptures(Path.of(args[0]))
        val counts = HashMap<Answer, Int>()
        for ((number, submission) in chosen.withIndex()) {
            if (number % parts != part) continue
            val answered =
                runCatching { OffscreenContext.open(ContextKind.OSMESA).use { Answered.of(submission, captures.of(submission)) } }
                    .getOrElse {
                        println("${submission.name}: FAILED ${it.javaClass.simpleName} ${it.message?.take(300)}")
                        null
                    }
                    ?: continue
            counts.merge(answered.answer, 1, Int::plus)
            if (answered.answer == Answer.NAMED || answered.answer == Answer.CLEAN) {
                val more = if (answered.elsewhere.isEmpty()) "" else " also costs ${answered.elsewhere}"
                println("${submission.name}: ${answered.answer} ${answered.points}$more")
            } else {
                val wanted = "wanted ${submission.expectation.mistakes} named ${answered.named} costs ${answered.costs}"
                val made = "parts ${submission.rewrites} notes ${answered.notes.take(4)}"
                println("${submission.name}: ${answered.answer} ${answered.points} $wanted $made")
            }
            if (System.getProperty("cga.corpus") == "all") answered.lines.forEach { println("    $it") }
        }
        println("TOTAL $counts")
    }
}

package cga.grading.course

import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.findings.FailureReason
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Graded
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.findings.Outcome
import cga.grading.findings.Refused
import cga.grading.findings.RunFacts
import cga.grading.report.GradedSubmission
import cga.grading.report.Language
import cga.grading.rubric.Rubric
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Grades a folder by the word in its file `what`; notes whom it graded. */
internal class FakeGrader(
    private val onGrade: (Path) -> Unit = {},
) : GradeOne {
    val graded = ConcurrentLinkedQueue<String>()
    var closed = 0

    override fun close() {
        closed++
    }

    override fun grade(submission: Path, folder: Path, listener: CheckListener): Outcome {
        graded += submission.name
        onGrade(submission)
        val checks = Check.entries.map { Measured(it, 0.0, "") }
        checks.forEach(listener::measured)
        val right = Findings(checks, emptyList(), emptyList(), emptyList(), emptyList())
        return when (val what = submission.resolve("what").readText()) {
            "right" -> Graded(right)
            "phong" -> Graded(Findings(checks, listOf(Found(Mistake.PHONG_LEFT, 0.0, 0.1, "")), emptyList(), emptyList(), emptyList()))
            "unconfined" -> Graded(right, RunFacts(isConfined = false))
            "loops" -> Refused(FailureReason.TIMED_OUT, "60 s")
            "throws" -> error("the grader broke")
            "overflows" -> overflow(0)
            "no memory" -> throw OutOfMemoryError("made up")
            "litters" -> Graded(right).also { folder.resolve("litter.exe").writeText("") }
            "link" -> {
                folder.resolve("measured.png").createSymbolicLinkPointingTo(Path.of("/etc/passwd"))
                Graded(Findings(checks, emptyList(), emptyList(), listOf(Evidence(null, Message.NONE, "measured.png", null)), emptyList()))
            }
            else -> error("unknown: $what")
        }
    }

    private fun overflow(depth: Int): Outcome = if (depth < 0) error("never") else overflow(depth + 1).also { graded.size }

    companion object {
        val settings = CourseSettings(Rubric.default(), Language.ENGLISH, jobs = 2)

        /** Submissions below [parent], by name and what they do. */
        fun submissions(parent: Path, vararg what: Pair<String, String>): List<Submission> {
            for ((name, word) in what) parent.resolve(name).createDirectories().resolve("what").writeText(word)
            return Submission.of(what.map { parent.resolve(it.first) })
        }

        fun run(
            out: Path,
            submissions: List<Submission>,
            grader: GradeOne,
            resume: Boolean = false,
            settings: CourseSettings = Companion.settings,
            shard: Shard = Shard.WHOLE,
        ) = ResultStore.open(out, resume).use { CourseRun(it, grader, settings, Silent).run(submissions, shard) }
    }

    object Silent : CourseListener {
        override fun finished(submission: GradedSubmission, isNew: Boolean) = Unit

        override fun problem(message: String) = error(message)
    }
}

package cga.grading.report

import cga.grading.course.CourseReport
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import java.nio.file.Path

/** Writes pages of made-up submissions into the folder that is named, to look at them. */
fun main(args: Array<String>) {
    val out = Path.of(args[0])
    val language = Language.entries.first { it.code == args[1] }
    val submissions =
        listOf(
            Fakes.submission(out, "anna", "Anna Meyer", Fakes::mistaken),
            Fakes.submission(out, "bo", "Bo Sørensen", Fakes::perfect),
            Fakes.submission(out, "cem") { Fakes.refused() },
            Fakes.submission(out, "dora", make = { Fakes.refused(FailureReason.NO_SANDBOX) }),
            Fakes.submission(out, "eve", "Eve ${Fakes.HOSTILE}", Fakes::hostile),
        )
    for (submission in submissions) {
        (submission.outcome as? Graded)?.let { Thumbnail.write(it.findings, submission.folder) }
        SubmissionPage.write(submission, language)
    }
    CourseReport.write(out, submissions, listOf("Finn"), language)
}

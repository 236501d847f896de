package cga.grading.course

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.grading.findings.Graded
import cga.grading.report.GradedSubmission
import cga.grading.report.GradescopeResults
import cga.grading.report.SubmissionPage
import cga.grading.report.Thumbnail
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Page, thumbnail and Gradescope's results of each submission; made again only where rubric or language are others than last time. */
internal class SubmissionReports(
    private val settings: CourseSettings,
) {
    private fun stamp(submission: GradedSubmission) =
        listOf(VERSION, settings.language.code, settings.rubric.fingerprint, *submission.twinParts.toTypedArray()).joinToString(" ")

    /** [submissions], which are all there are, with what they share, and their pages with that. */
    fun withTwins(submissions: List<GradedSubmission>, listener: CourseListener): List<GradedSubmission> =
        Twins.marked(submissions).onEach { if (it.twins.isNotEmpty()) writeOrComplain(it, listener) }

    /** As [write]; a failure is told to [listener] and costs nothing else. */
    fun writeOrComplain(submission: GradedSubmission, listener: CourseListener) {
        try {
            write(submission)
        } catch (e: InputError) {
            listener.problem("${submission.name}: no page: ${e.message}")
        } catch (e: RuntimeException) {
            listener.problem("${submission.name}: no page: $e")
        }
    }

    private fun write(submission: GradedSubmission) {
        settings.gradescope?.let { GradescopeResults.write(submission, settings.language, it) }
        val file = submission.folder.resolve(STAMP)
        val stamp = stamp(submission)
        val isCurrent = file.exists() && submission.folder.resolve(GradedSubmission.PAGE).exists() && file.readText() == stamp
        if (isCurrent) return
        file.deleteIfExists()
        (submission.outcome as? Graded)?.let { Thumbnail.write(it.findings, submission.folder) }
        SubmissionPage.write(submission, settings.language)
        GradescopeResults.write(submission, settings.language, submission.folder.resolve(RESULTS))
        AtomicFile.write(file) { it.writeText(stamp) }
    }

    companion object {
        /** Of the pages' form; with another they are made again. */
        private const val VERSION = "2"
        private const val STAMP = ".report"
        const val RESULTS = "results.json"
    }
}

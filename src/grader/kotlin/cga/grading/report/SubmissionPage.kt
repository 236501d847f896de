package cga.grading.report

import cga.grading.findings.Findings
import cga.grading.findings.Graded
import kotlinx.html.DETAILS
import kotlinx.html.FlowContent
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.h1
import kotlinx.html.h2
import kotlinx.html.header
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.progress
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.strong
import kotlinx.html.summary
import kotlinx.html.ul

/** The page of one submission, as its student reads it. */
public object SubmissionPage {
    /** Writes `report.html` into the submission's folder. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(submission: GradedSubmission, language: Language) {
        val messages = Messages.of(language)
        val title = messages.text("page.title", cleanLine(submission.name))
        ReportPage.write(title, messages, submission.folder.resolve(GradedSubmission.PAGE)) {
            heading(submission, messages)
            val findings = (submission.outcome as? Graded)?.findings
            if (findings == null) refusal(submission, messages) else measured(submission, findings, messages)
            howGraded(submission, messages)
        }
    }

    private fun FlowContent.measured(submission: GradedSubmission, findings: Findings, messages: Messages) {
        val grade = submission.grade ?: return
        val pictures = EvidencePictures(submission.folder, findings, messages)
        mistakes(findings, grade, pictures, messages)
        mainPicture(pictures, messages)
        pointsTable(grade, messages)
        curves(findings.plots, messages)
        lights(pictures, messages)
        val notes = findings.notes.map(messages::say) + pictures.complaints
        if (notes.isNotEmpty()) {
            part(messages.text("page.notes")) { ul { notes.forEach { li { +cleanLine(it, NOTE) } } } }
        }
    }

    private fun FlowContent.heading(submission: GradedSubmission, messages: Messages) {
        val points = submission.points
        header {
            h1 { span("name") { +cleanLine(submission.name) } }
            div("score") {
                if (points == null) {
                    p("warn") { +messages.text("page.no-points") }
                } else {
                    val (reached, total) = messages.number(points) to messages.number(submission.rubric.total)
                    p {
                        strong { +reached }
                        +" / $total"
                    }
                    progress {
                        max = "${submission.rubric.total}"
                        value = "$points"
                        attributes["aria-label"] = messages.text("page.of", reached, total)
                    }
                }
            }
        }
        // Who the others are stands on the contact sheet: this page is for a student.
        if (submission.twinParts.isNotEmpty()) {
            p("open warn") { +("≈ " + messages.text("page.twins", messages.list(submission.twinParts))) }
        }
        if (submission.solutionParts.isNotEmpty()) {
            p("open warn") { +("≈ " + messages.text("page.like-solution", messages.list(submission.solutionParts))) }
        }
        if (!submission.outcome.facts.isConfined) p("open warn") { +("! " + messages.text("page.no-sandbox")) }
        val open = submission.grade?.open ?: 0.0
        if (open > 0) p("open warn") { +("? " + messages.text("page.open", messages.number(open))) }
    }

    private fun FlowContent.refusal(submission: GradedSubmission, messages: Messages) {
        val refusal = submission.refusal ?: return
        val words = messages.of(refusal.reason)
        section("case fail") {
            div("card") {
                h2 { +words.title }
                p { +words.text }
                if (refusal.detail.isNotBlank()) {
                    p("figures") { +cleanLine(messages.say(refusal.detail), NOTE) }
                }
                hint(words.hint, messages)
            }
        }
    }

    private const val NOTE = 2000
}

/** A part of the page that can be folded up. */
internal fun FlowContent.part(title: String, isOpen: Boolean = true, content: DETAILS.() -> Unit) {
    section("part") {
        details {
            open = isOpen
            summary { h2 { +title } }
            content()
        }
    }
}

internal fun FlowContent.hint(text: String, messages: Messages) {
    p("hint") {
        strong { +messages.text("page.hint") }
        +" $text"
    }
}

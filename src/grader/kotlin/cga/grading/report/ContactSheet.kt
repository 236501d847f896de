package cga.grading.report

import cga.grading.findings.Check
import cga.grading.findings.Graded
import cga.grading.findings.Mistake
import kotlinx.html.ButtonType
import kotlinx.html.FlowContent
import kotlinx.html.TBODY
import kotlinx.html.TR
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.h1
import kotlinx.html.img
import kotlinx.html.p
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import java.nio.file.Path

/** The page over all submissions: a picture, the points and the mistakes of each, sortable, and which mistakes are frequent. */
public object ContactSheet {
    /** Writes the sheet to [file]; [missing] are the names of those without a result. Throws [cga.framework.InputError] if it cannot. */
    public fun write(submissions: List<GradedSubmission>, missing: List<String>, language: Language, file: Path) {
        val messages = Messages.of(language)
        ReportPage.write(messages.text("page.course"), messages, file) {
            h1 { +messages.text("page.course") }
            summary(submissions, missing, messages)
            table(submissions, missing, messages)
            frequent(submissions, messages)
        }
    }

    private fun FlowContent.summary(submissions: List<GradedSubmission>, missing: List<String>, messages: Messages) {
        val points = submissions.mapNotNull { it.grade?.points }.sorted()
        val all = submissions.size + missing.size
        p("lead") { +messages.text("course.summary", all, points.size, submissions.size - points.size) }
        if (points.isNotEmpty()) {
            val median = (points[(points.size - 1) / 2] + points[points.size / 2]) / 2
            val (mean, middle) = messages.number(points.average()) to messages.number(median)
            p("lead") { +messages.text("course.mean", mean, messages.number(submissions.first().rubric.total), middle) }
        }
        val open = submissions.count { (it.grade?.open ?: 0.0) > 0 }
        if (open > 0) p("lead warn") { +("? " + messages.text("course.open", open)) }
        val alike = submissions.count { it.twins.isNotEmpty() || it.solutionParts.isNotEmpty() }
        if (alike > 0) p("lead warn") { +("≈ " + messages.text("course.twins", alike)) }
        val unconfined = submissions.count { !it.outcome.facts.isConfined }
        if (unconfined > 0) p("lead warn") { +("! " + messages.text("course.no-sandbox", unconfined)) }
        if (missing.isNotEmpty()) p("lead fail") { +"${messages.text("course.missing")}: ${missing.joinToString { cleanLine(it) }}" }
        p("lead") { a("grades.csv") { +messages.text("course.table") } }
    }

    private val TASKS = Check.entries.map { it.task }.distinct()

    private fun FlowContent.table(submissions: List<GradedSubmission>, missing: List<String>, messages: Messages) {
        div("scroll") {
            table("sheet") {
                thead {
                    tr {
                        th(scope = ThScope.col) { }
                        column(messages.text("course.submission"), messages)
                        column(messages.text("page.score"), messages, "number", "descending")
                        for (task in TASKS) column(task, messages, "number of-task", "descending")
                        column(messages.text("course.mistakes"), messages)
                        column(messages.text("page.seconds"), messages, "number of-task", "descending")
                    }
                }
                tbody {
                    submissions.forEach { row(it, messages) }
                    missing.forEach { missing(it, messages) }
                }
            }
        }
    }

    private fun TR.column(name: String, messages: Messages, classes: String = "", first: String = "ascending") {
        th(scope = ThScope.col, classes = classes) {
            attributes["data-first"] = first
            button(type = ButtonType.button) {
                attributes["title"] = messages.text("course.sort", name)
                +name
            }
        }
    }

    private fun TBODY.row(submission: GradedSubmission, messages: Messages) {
        val grade = submission.grade
        tr {
            td("thumbnail") { Thumbnail.url(submission.folder)?.let { img(alt = "", src = it) } }
            val name = cleanLine(submission.name)
            cell("name", name) { a("${submission.folder.fileName}/${GradedSubmission.PAGE}") { +name } }
            cell("number", submission.points?.toString()) {
                +(submission.points?.let { messages.number(it) } ?: "–")
                if ((grade?.open ?: 0.0) > 0) +" + ${messages.number(grade?.open ?: 0.0)} ?"
            }
            for (task in TASKS) {
                val points = grade?.tasks?.find { it.task == task }?.points
                cell("number of-task", points?.toString()) { +(points?.let { messages.number(it) } ?: "–") }
            }
            val why = why(submission, messages)
            cell("why", why.ifEmpty { null }) {
                +why
                alike(submission, messages).forEach { p("warn") { +"≈ $it" } }
            }
            cell("number of-task", "${submission.seconds}") { +"${messages.number(submission.seconds)} s" }
        }
    }

    /** What of it is the same elsewhere, and where. */
    private fun alike(submission: GradedSubmission, messages: Messages): List<String> {
        val others = submission.twinGroups.map { (parts, names) ->
            val more = if (names.size > MOST_TWINS) " … (${names.size})" else ""
            messages.text("course.same", messages.list(parts), names.take(MOST_TWINS).joinToString(transform = ::cleanLine) + more)
        }
        val solution = submission.solutionParts
        return others + if (solution.isEmpty()) emptyList() else listOf(messages.text("course.like-solution", messages.list(solution)))
    }

    private fun TBODY.missing(name: String, messages: Messages) {
        tr("empty") {
            td("thumbnail") { }
            cell("name", cleanLine(name)) { +cleanLine(name) }
            repeat(1 + TASKS.size) { cell(if (it == 0) "number" else "number of-task", null) { +"–" } }
            cell("why", messages.text("course.missing")) { +messages.text("course.missing") }
            cell("number of-task", null) { }
        }
    }

    private fun TR.cell(classes: String, sort: String?, content: FlowContent.() -> Unit) {
        td(classes) {
            sort?.let { attributes["data-sort"] = it }
            content()
        }
    }

    private fun why(submission: GradedSubmission, messages: Messages): String =
        submission.refusal?.let { messages.of(it.reason).title } ?: mistakes(submission).joinToString("; ") { messages.of(it).title }

    private fun mistakes(submission: GradedSubmission): List<Mistake> =
        (submission.outcome as? Graded)?.findings?.mistakes.orEmpty().map { it.mistake }.distinct()

    /** What to talk about in the next lecture. */
    private fun FlowContent.frequent(submissions: List<GradedSubmission>, messages: Messages) {
        val counts = submissions.flatMap(::mistakes).groupingBy { it }.eachCount().entries.sortedByDescending { it.value }
        if (counts.isEmpty()) return
        part(messages.text("course.frequent")) {
            table("frequent") {
                thead {
                    tr {
                        th(scope = ThScope.col) { +messages.text("course.mistakes") }
                        th(scope = ThScope.col, classes = "number") { +messages.text("course.count") }
                    }
                }
                tbody {
                    for ((mistake, count) in counts.take(MOST_FREQUENT)) {
                        tr {
                            td { +messages.of(mistake).title }
                            td("number") { +"$count" }
                        }
                    }
                }
            }
        }
    }

    private const val MOST_FREQUENT = 12
    private const val MOST_TWINS = 5
}

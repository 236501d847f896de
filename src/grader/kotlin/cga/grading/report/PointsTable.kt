package cga.grading.report

import cga.grading.rubric.CheckGrade
import cga.grading.rubric.CheckState
import cga.grading.rubric.Grade
import cga.grading.rubric.TaskGrade
import kotlinx.html.FlowContent
import kotlinx.html.TBODY
import kotlinx.html.TD
import kotlinx.html.ThScope
import kotlinx.html.div
import kotlinx.html.p
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.tfoot
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr

/** The points, task by task and check by check. */
internal fun FlowContent.pointsTable(grade: Grade, messages: Messages) {
    part(messages.text("page.points")) {
        div("scroll") {
            table("points") {
                thead {
                    tr {
                        th(scope = ThScope.col) { +messages.text("page.check") }
                        th(scope = ThScope.col) { +messages.text("page.result") }
                        th(scope = ThScope.col, classes = "number") { +messages.text("page.score") }
                    }
                }
                grade.tasks.forEach { task -> tbody { task(task, messages) } }
                tfoot {
                    tr("task") {
                        th(scope = ThScope.row) { +messages.text("page.total") }
                        td { }
                        td("number") { +messages.text("page.of-short", messages.number(grade.points), messages.number(grade.maximum)) }
                    }
                }
            }
        }
    }
}

private fun TBODY.task(task: TaskGrade, messages: Messages) {
    tr("task") {
        th(scope = ThScope.rowGroup) { +"${task.task} ${messages.text("task.${task.task}")}" }
        td { }
        td("number") { +messages.text("page.of-short", messages.number(task.points), messages.number(task.maximum)) }
    }
    for (check in task.checks) {
        if (check.maximum == 0.0) continue
        tr {
            td("what") { what(check, messages) }
            td { span("state ${style(check.state)}") { +"${sign(check.state)} ${messages.of(check.state)}" } }
            td("number") {
                val points = check.points?.let { messages.number(it) } ?: "?"
                +messages.text("page.of-short", points, messages.number(check.maximum))
            }
        }
    }
}

private fun TD.what(check: CheckGrade, messages: Messages) {
    val words = messages.of(check.check)
    p {
        attributes["title"] = words.text
        +words.title
    }
    val cause = check.cause
    val said = said(check, messages)
    val (error, state) = check.error to check.state
    when {
        state == CheckState.EXPLAINED && cause != null -> p("remark") { +messages.text("page.explained-by", messages.of(cause).title) }
        // The study says the mistake's title itself, and where it was found.
        state == CheckState.MISTAKE && cause != null -> messages.of(cause).title.let { if (it !in said) p("remark") { +it } }
        state == CheckState.INEXACT && error != null -> p(
            "remark",
        ) { +"${messages.text("page.error", messages.percent(error))}. ${words.hint}" }
        state == CheckState.NOT_FOUND -> p("remark") { +words.hint }
        else -> Unit
    }
    if (said.isNotBlank()) p("remark") { +said }
}

/** What was measured of [check], as a reader sees it. */
internal fun said(check: CheckGrade, messages: Messages): String = cleanLine(messages.say(check.message), MOST_SAID)

internal const val MOST_SAID: Int = 600

/** Never told by its colour alone. */
internal fun sign(state: CheckState): String =
    when (state) {
        CheckState.RIGHT -> "✓"
        CheckState.EXPLAINED -> "↳"
        CheckState.OPEN -> "?"
        CheckState.INEXACT -> "≠"
        CheckState.MISTAKE, CheckState.NOT_FOUND -> "✕"
    }

private fun style(state: CheckState): String =
    when (state) {
        CheckState.RIGHT -> "pass"
        CheckState.EXPLAINED, CheckState.OPEN -> "warn"
        CheckState.INEXACT, CheckState.MISTAKE, CheckState.NOT_FOUND -> "fail"
    }

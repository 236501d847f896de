package cga.imaging.report

import cga.imaging.Comparison
import cga.imaging.Severity
import cga.imaging.brief
import cga.imaging.percent
import cga.imaging.step
import kotlinx.html.FlowContent
import kotlinx.html.InputType
import kotlinx.html.TBODY
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.bdi
import kotlinx.html.div
import kotlinx.html.fieldSet
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.legend
import kotlinx.html.p
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr

/** Sign and word of a severity: never told by its colour alone. */
internal fun FlowContent.badge(severity: Severity) {
    span("badge ${severity.style}") { +"${severity.sign} ${severity.word}" }
}

/** Name of its style, and of its choice in the filter. */
internal val Severity.style: String get() = name.lowercase()

private val Severity.sign: String
    get() =
        when (this) {
            Severity.PASS -> "✓"
            Severity.WARN -> "!"
            Severity.FAIL -> "✕"
        }

private val Severity.word: String
    get() =
        when (this) {
            Severity.PASS -> "passed"
            Severity.WARN -> "warning"
            Severity.FAIL -> "failed"
        }

/** How many cases ended how, which of them to show, and each in one line. */
internal fun FlowContent.overview(views: List<CaseView>) {
    filter(views)
    if (views.isEmpty()) return p { +"There are no cases." }
    div("scroll") {
        table("overview") {
            thead {
                tr {
                    for (column in listOf("Result", "Picture", "Case")) th(scope = ThScope.col) { +column }
                    for (column in NUMBERS) th(scope = ThScope.col, classes = "number") { +column }
                }
            }
            tbody { views.forEach { row(it) } }
        }
    }
}

private fun FlowContent.filter(views: List<CaseView>) {
    fieldSet("filter") {
        legend { +"Show" }
        choice("all", "all ${views.size}", isChosen = true)
        for (severity in Severity.entries.reversed()) {
            val count = views.count { it.case.severity == severity }
            val words = if (severity == Severity.WARN && count != 1) "warnings" else severity.word
            choice(severity.style, "${severity.sign} $count $words", isChosen = false)
        }
    }
}

private fun FlowContent.choice(choice: String, words: String, isChosen: Boolean) {
    label(choice) {
        input(InputType.radio, name = "severity") {
            value = choice
            checked = isChosen
        }
        +" $words"
    }
}

private fun TBODY.row(view: CaseView) {
    val case = view.case
    tr {
        attributes["data-severity"] = case.severity.style
        td { badge(case.severity) }
        td("thumbnail") { (view.pair?.actual ?: view.picture)?.let { attributes["data-picture"] = it.id } }
        td("name") {
            a("#${view.id}") { bdi { +case.name } }
            case.messages.firstOrNull()?.let { p { +it } }
        }
        val numbers = case.comparison?.let(::numbers) ?: NUMBERS.map { "" }
        numbers.forEach { td("number") { +it } }
    }
}

private val NUMBERS = listOf("Largest difference", "Pixels that differ", "ꟻLIP mean")

private fun numbers(comparison: Comparison): List<String> {
    val difference = comparison.difference
    // Of pictures that are the same ꟻLIP need not be computed.
    val flip = if (comparison.isIdentical) 0.0 else comparison.flip.mean
    return listOf(step(difference.maximum.max(), comparison.expected), percent(difference.fraction), brief(flip))
}

package cga.grading.report

import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Mistake
import cga.grading.findings.Place
import cga.grading.findings.Proof
import cga.grading.rubric.CheckGrade
import cga.grading.rubric.CheckState
import cga.grading.rubric.Grade
import kotlinx.html.FlowContent
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.h2
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.pre
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.strong
import kotlinx.html.summary
import kotlinx.html.ul

/** A card for each mistake: what it is, what it costs, a hint, and the pictures that prove it. */
internal fun FlowContent.mistakes(findings: Findings, grade: Grade, pictures: EvidencePictures, messages: Messages) {
    val mistakes = findings.mistakes.distinctBy { it.mistake to it.where }
    if (mistakes.isEmpty()) {
        if (grade.checks.all { it.state == CheckState.RIGHT }) p("faultless pass") { +("✓ " + messages.text("page.faultless")) }
        return
    }
    h2("heading") { +messages.text("page.mistakes") }
    findings.proof?.let { p("note") { +said("page.proof-all", it, messages) } }
    val told = mutableSetOf<Any>()
    for (found in mistakes) {
        val home = grade.checks.find { it.state == CheckState.MISTAKE && it.cause == found.mistake }?.takeIf { told.add(it) }
        val proofs = if (told.add("proofs of ${found.mistake.check}")) pictures.proofs(found.mistake.check) else emptyList()
        val seen = if (found.mistake == Mistake.UNKNOWN) deviations(grade, messages) else emptyList()
        card(found, cost(found.mistake, home, grade, messages), seen, proofs, messages)
    }
}

/** What was measured of the checks that cost something and that no mistake with a name explains, a sentence each. */
internal fun deviations(grade: Grade, messages: Messages): List<String> {
    val title = messages.of(Mistake.UNKNOWN).title
    val said = grade.checks.filter { it.state == CheckState.INEXACT }.map { it.check to said(it, messages) }
    val told = said.filter { (_, text) -> text.isNotBlank() && title !in text }.take(MOST_DEVIATIONS)
    return told.map { (check, text) -> "${messages.of(check).title}: $text" }
}

/** @param cost what it costs, in words; null for nothing. */
private fun FlowContent.card(found: Found, cost: String?, seen: List<String>, proofs: List<EvidenceView>, messages: Messages) {
    val words = messages.of(found.mistake)
    section(if (cost != null || found.mistake == Mistake.UNKNOWN) "case fail" else "case warn") {
        details {
            open = true
            summary {
                h2 { +words.title }
                // What has no name costs where it is measured.
                if (found.mistake != Mistake.UNKNOWN) span("cost") { +(cost ?: messages.text("page.costs-nothing")) }
            }
            p { +words.text }
            if (seen.isNotEmpty()) ul { seen.forEach { li { +it } } }
            if (found.where.isNotBlank()) p("figures") { +"${messages.text("page.where")}: ${cleanLine(messages.say(found.where))}" }
            found.details.forEach { p("figures") { +cleanLine(messages.say(it), MOST_SAID) } }
            places(found.places, messages)
            if (found.alternatives.isNotEmpty()) {
                p {
                    +messages.text(
                        "page.or",
                        found.alternatives.joinToString("; ") { messages.of(it).title },
                    )
                }
            }
            hint(words.hint, messages)
            proofs.take(MOST_PROOFS).forEach { proof(it, messages) }
            val proof = found.proof
            if (proof != null) {
                p("note") { +said("page.proof", proof, messages) }
            } else if (found.mistake !in UNFITTED && found.difference > 0) {
                p("note") { +messages.text("page.fit", messages.percent((found.fit / found.difference).coerceIn(0.0, 1.0))) }
            }
        }
    }
}

/** The line, with the source around it; below it who called it. */
private fun FlowContent.places(places: List<Place>, messages: Messages) {
    val first = places.firstOrNull() ?: return
    p("figures") { +"${messages.text("page.line")}: ${cleanLine("$first")}" }
    if (first.source.isNotEmpty()) {
        pre("source") {
            attributes["tabindex"] = "0"
            first.source.forEachIndexed { i, line ->
                val number = first.first + i
                val text = "${"$number".padStart(NUMBER)}  ${clean(line)}\n"
                if (number == first.line) strong { +text } else +text
            }
        }
    }
    val callers = places.drop(1)
    if (callers.isNotEmpty()) p("figures") { +messages.text("page.called-by", callers.joinToString(" ← ") { cleanLine("$it") }) }
}

private fun said(key: String, proof: Proof, messages: Messages): String =
    messages.text(key, messages.percent(proof.explained.coerceIn(0.0, 1.0)), messages.number(proof.left, 1))

/** What no formula was fitted for: it is unknown, or a log tells it. */
private val UNFITTED =
    setOf(
        Mistake.UNKNOWN, Mistake.SHADER_REFUSED, Mistake.GLSL_DRIVER, Mistake.KOTLIN_REFUSED, Mistake.UNIFORM_ABSENT,
        Mistake.UNIFORM_BEFORE_USE,
    )

private fun FlowContent.proof(view: EvidenceView, messages: Messages) {
    p("caption") { +cleanLine(messages.say(view.evidence.title)) }
    div(if (view.expected == null) "alone" else "pairing") { pair(view, messages) }
}

/**
 * What [mistake] costs, in words; null for nothing.
 *
 * @param home the check that it costs, and that no card before has told of.
 */
internal fun cost(mistake: Mistake, home: CheckGrade?, grade: Grade, messages: Messages): String? {
    val lost = home?.run { maximum - (points ?: maximum) } ?: 0.0
    val own = if (home != null && lost > 0) "−${messages.number(lost)} · ${messages.of(home.check).title}" else null
    val more =
        when (mistake) {
            // All that belongs to a file goes with it.
            Mistake.KOTLIN_REFUSED -> {
                val gone = grade.checks.filter { it.state == CheckState.NOT_FOUND && it.message.key == REPLACED }.sumOf { it.maximum }
                if (gone > 0) messages.text("page.costs-file", messages.number(gone)) else null
            }
            Mistake.SHADER_REFUSED -> if (grade.open > 0) messages.text("page.costs-open", messages.number(grade.open)) else null
            else -> null
        }
    return listOfNotNull(own, more).joinToString("; ").ifEmpty { null }
}

/** What is said of a check whose file was replaced. */
private const val REPLACED = "said.file-replaced"
private const val MOST_PROOFS = 3
private const val NUMBER = 4
private const val MOST_DEVIATIONS = 5

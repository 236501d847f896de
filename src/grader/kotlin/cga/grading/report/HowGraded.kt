package cga.grading.report

import kotlinx.html.FlowContent
import kotlinx.html.dd
import kotlinx.html.details
import kotlinx.html.dl
import kotlinx.html.dt
import kotlinx.html.pre
import kotlinx.html.summary

/** Compiler, edition, times, and what the stages said. */
internal fun FlowContent.howGraded(submission: GradedSubmission, messages: Messages) {
    val facts = submission.outcome.facts
    val refused = submission.refusal != null
    part(messages.text("page.how"), isOpen = refused) {
        dl {
            val stages = facts.seconds.entries.joinToString(
                " · ",
            ) { (stage, seconds) -> "${cleanLine(messages.say(stage))} ${messages.number(seconds)} s" }
            val rows =
                listOf(
                    "page.kind" to facts.kind?.let(messages::say),
                    "page.edition" to facts.edition?.let(messages::say),
                    "page.compiler" to facts.compiler?.let(messages::say),
                    "page.rubric" to submission.rubric.name,
                    "page.seconds" to messages.number(submission.seconds) + " s" + if (stages.isEmpty()) "" else " ($stages)",
                    "page.memory" to facts.peakBytes?.let { "${it shr 20} MiB" },
                )
            for ((key, value) in rows) {
                if (value == null) continue
                dt { +messages.text(key) }
                dd { +cleanLine(value) }
            }
        }
        for (log in facts.logs.take(MOST_LOGS)) {
            details("log") {
                open = refused
                summary { +messages.text("page.log", cleanLine(messages.say(log.title))) }
                pre {
                    attributes["tabindex"] = "0"
                    +excerpt(log.text)
                }
            }
        }
    }
}

/** Beginning and end of a log: the first error stands at the one, what it died of at the other. */
internal fun excerpt(log: String): String {
    val text = clean(log.take(MOST_READ))
    if (text.length <= MOST_SHOWN) return text
    return text.take(MOST_SHOWN / 2) + "\n\n[…]\n\n" + text.takeLast(MOST_SHOWN / 2)
}

private const val MOST_LOGS = 12
private const val MOST_SHOWN = 12_000
private const val MOST_READ = 1_000_000

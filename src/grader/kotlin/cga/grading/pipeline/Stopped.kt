package cga.grading.pipeline

import cga.grading.findings.FailureReason
import cga.grading.sandbox.End
import cga.grading.sandbox.Limit
import cga.grading.sandbox.Outcome

/** A submission cannot go on to the next step. */
internal class Stopped(
    val reason: FailureReason,
    val detail: String,
) : Exception(detail)

/**
 * Throws [Stopped] where [outcome] of [step] is that of a job killed, crashed or ended with a code that is not 0; [codes] gives codes a reason,
 * [otherwise] is that of all others. Where a code has a reason, what the step itself said is the whole detail.
 */
internal fun checkEnd(
    step: String,
    outcome: Outcome,
    codes: Map<Int, FailureReason> = emptyMap(),
    otherwise: FailureReason = FailureReason.EXITED,
) {
    when (val end = outcome.end) {
        is End.Exited -> {
            if (end.code == 0) return
            val said = outcome.errors.lines().filter(String::isNotBlank).takeLast(LAST_LINES).joinToString("\n")
            val known = codes[end.code]
            val detail = if (known != null && said != "") said else "$step ended with exit code ${end.code}.\n$said".trim()
            throw Stopped(known ?: otherwise, detail)
        }
        is End.Signalled -> throw Stopped(FailureReason.CRASHED, "$step crashed with signal ${end.signal}.")
        is End.Exceeded -> throw Stopped(
            reason(end.limit),
            "$step was ended after ${"%.1f".format(outcome.wallSeconds)} s: ${words(end.limit)}.",
        )
    }
}

private const val LAST_LINES = 12

private fun reason(limit: Limit): FailureReason =
    when (limit) {
        Limit.WALL_CLOCK, Limit.CPU -> FailureReason.TIMED_OUT
        Limit.MEMORY -> FailureReason.OUT_OF_MEMORY
        Limit.PROCESSES -> FailureReason.TOO_MANY_PROCESSES
        Limit.OUTPUT, Limit.DISK -> FailureReason.TOO_MUCH_OUTPUT
    }

private fun words(limit: Limit): String =
    when (limit) {
        Limit.WALL_CLOCK -> "it took too long"
        Limit.CPU -> "it took too much processor time"
        Limit.MEMORY -> "it took too much memory"
        Limit.PROCESSES -> "it started too many processes or threads"
        Limit.OUTPUT -> "it wrote too much output"
        Limit.DISK -> "it wrote too much to the disk"
    }

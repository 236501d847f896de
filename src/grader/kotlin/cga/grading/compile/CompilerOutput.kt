package cga.grading.compile

import cga.grading.sandbox.End
import cga.grading.sandbox.Outcome

/** Reads what compilers print. */
internal object CompilerOutput {
    private const val MOST_ERRORS = 100
    private const val LONGEST_MESSAGE = 1000

    /** `file:line:column: error: message`, without the column by javac. */
    private val WITH_PLACE = Regex("""^(.+?\.(?:kt|java)):(\d+)(?::\d+)?: error: (.*)$""")
    private val WITHOUT_PLACE = Regex("""^(?:error|exception): (.*)$""")

    /** The errors that [outcome] reports, at least one unless it is a success. */
    fun errors(outcome: Outcome, stage: Stage): List<CompileError> {
        if (outcome.isSuccess) return emptyList()
        val lines = (outcome.errors.lines() + outcome.output.lines())
        val errors = lines.mapNotNull { line ->
            placed(line, stage)
                ?: WITHOUT_PLACE.find(line)?.let { CompileError(null, 0, short(it.groupValues[1])) }
        }
        return errors.take(MOST_ERRORS).ifEmpty { listOf(CompileError(null, 0, ending(outcome))) }
    }

    private fun placed(line: String, stage: Stage): CompileError? {
        val (path, number, message) = WITH_PLACE.find(line)?.destructured ?: return null
        return CompileError(stage.name(path), number.toIntOrNull() ?: 0, short(message))
    }

    private fun ending(outcome: Outcome): String =
        when (val end = outcome.end) {
            is End.Exceeded -> "the compiler was stopped: ${end.limit.name.lowercase().replace('_', ' ')} exceeded"
            is End.Signalled -> "the compiler crashed (signal ${end.signal})"
            is End.Exited -> short("the compiler failed (exit code ${end.code}): ${outcome.errors.trim()}")
        }

    private fun short(text: String) = text.take(LONGEST_MESSAGE)
}

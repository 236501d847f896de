package cga.grading.compile

import cga.grading.prepared.PreparedSource
import cga.grading.sandbox.End
import cga.grading.sandbox.Outcome

/** Reads what compilers print about [sources]: line by line, each looked at once, as it quotes what a student wrote. */
internal class CompilerOutput(
    sources: List<PreparedSource>,
) {
    private val sources = sources.associateBy { it.file }

    /** The errors that [outcome] reports, at least one unless it is a success. */
    fun errors(outcome: Outcome): List<CompileError> {
        if (outcome.isSuccess) return emptyList()
        val lines = outcome.errors.lines() + outcome.output.lines()
        val errors = lines.mapNotNull { placed(it) ?: unplaced(it) }.take(MOST_ERRORS)
        // A compiler that fails itself says somewhere at which file, if it knows.
        val failure =
            errors.firstOrNull { it.source == null } ?: CompileError(null, 0, ending(outcome)).takeIf { errors.isEmpty() } ?: return errors
        val named = sources.values.filter { source -> lines.any { "/${source.file}" in it.take(LONGEST_LINE) } }
        return named.map { failure.copy(source = it, message = failure.message.calling(it)) }.ifEmpty { listOf(failure) }
    }

    /** With the student's name for [source] where a path of ours stands. */
    private fun String.calling(source: PreparedSource) =
        split(' ').joinToString(" ") { word -> if ("/${source.file}" in word) source.name else word }

    /** `file:line:column: error: message`, without the column by javac. */
    private fun placed(line: String): CompileError? {
        val error = line.indexOf(ERROR)
        if (error < 0) return null
        val parts = line.substring(0, error).split(':')
        val numbers = parts.takeLast(2).mapNotNull(String::toIntOrNull)
        val path = parts.dropLast(numbers.size).lastOrNull().orEmpty()
        val source = sources[path.split('/').takeLast(2).joinToString("/")] ?: return null
        return CompileError(source, numbers.firstOrNull() ?: 0, line.substring(error + ERROR.length).take(LONGEST_MESSAGE))
    }

    private fun unplaced(line: String): CompileError? {
        val kind = FAILURES.firstOrNull(line::startsWith) ?: return null
        return CompileError(null, 0, line.removePrefix(kind).take(LONGEST_MESSAGE))
    }

    private fun ending(outcome: Outcome): String =
        when (val end = outcome.end) {
            is End.Exceeded -> "the compiler was stopped: ${end.limit.name.lowercase().replace('_', ' ')} exceeded"
            is End.Signalled -> "the compiler crashed (signal ${end.signal})"
            is End.Exited -> "the compiler failed (exit code ${end.code}): ${outcome.errors.trim()}".take(LONGEST_MESSAGE)
        }

    private companion object {
        const val MOST_ERRORS = 100
        const val LONGEST_MESSAGE = 1000
        const val LONGEST_LINE = 10_000
        const val ERROR = ": error: "
        val FAILURES = listOf("error: ", "exception: ")
    }
}

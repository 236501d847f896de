package cga.grading.report

import cga.framework.AtomicFile
import cga.grading.findings.Check
import cga.grading.findings.Graded
import java.nio.file.Path
import java.util.Locale
import kotlin.io.path.writeText

/**
 * The table over all submissions, as RFC 4180 has it: commas, CRLF, UTF-8, one line a submission, a header. Its columns and its decimal points
 * are the same in every language. A cell that a spreadsheet would take for a formula has an apostrophe before it.
 */
public object GradesCsv {
    /** Writes the table to [file]; [missing] are the names of those without a result. Throws [cga.framework.InputError] if it cannot. */
    public fun write(submissions: List<GradedSubmission>, missing: List<String>, file: Path) {
        val rows = listOf(HEADER) + submissions.map(::row) + missing.map { listOf(cleanLine(it), "missing") + List(HEADER.size - 2) { "" } }
        AtomicFile.write(file) { it.writeText(rows.joinToString("") { row -> row.joinToString(",", transform = ::cell) + "\r\n" }) }
    }

    private val TASKS = Check.entries.map { it.task }.distinct()
    private val HEADER =
        listOf("submission", "outcome", "points", "open", "maximum") + TASKS +
            listOf("mistakes", "reason", "same_as", "kind", "edition", "compiler", "sandbox", "seconds", "peak_mib", "page")

    private fun row(submission: GradedSubmission): List<String> {
        val grade = submission.grade
        val facts = submission.outcome.facts
        val mistakes = (submission.outcome as? Graded)?.findings?.mistakes.orEmpty()
        return listOf(
            cleanLine(submission.name),
            if (grade == null) "refused" else "graded",
            submission.points?.let(::number).orEmpty(),
            grade?.open?.let(::number).orEmpty(),
            number(submission.rubric.total),
        ) + TASKS.map { task -> grade?.tasks?.find { it.task == task }?.let { number(it.points) }.orEmpty() } +
            listOf(
                mistakes.map { it.mistake.id }.distinct().joinToString(" "),
                submission.refusal?.let { "${it.reason.id}: ${it.detail}" }.orEmpty(),
                sameAs(submission),
                facts.kind.orEmpty(),
                facts.edition.orEmpty(),
                facts.compiler.orEmpty(),
                if (facts.isConfined) "yes" else "no",
                number(submission.seconds),
                facts.peakBytes?.let { "${it shr 20}" }.orEmpty(),
                "${submission.folder.fileName}/${GradedSubmission.PAGE}",
            )
    }

    /** Parts and where they are the same: `kotlin shaders: anna, bo; shaders: the solution`. */
    private fun sameAs(submission: GradedSubmission): String {
        val solution = listOf(submission.solutionParts to listOf(SOLUTION)).filter { it.first.isNotEmpty() }
        return (submission.twinGroups.toList() + solution).joinToString("; ") { (parts, names) ->
            parts.joinToString(" ") { it.id } + ": " + names.joinToString()
        }
    }

    private fun number(value: Double) = "%.1f".format(Locale.ROOT, value).removeSuffix(".0")

    private fun cell(value: String): String {
        val text = cleanLine(value, CELL)
        // What spreadsheets take for a formula, also after blanks, and in its full-width forms.
        val isFormula = text.trimStart().firstOrNull()?.let { it in "=+-@|%＝＋－＠" } == true && text.toDoubleOrNull() == null
        val safe = if (isFormula) "'$text" else text
        return if (safe.any { it in ",\"\r\n" }) "\"" + safe.replace("\"", "\"\"") + "\"" else safe
    }

    private const val CELL = 1000
    private const val SOLUTION = "the solution"
}

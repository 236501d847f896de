package cga.grading.report

import cga.framework.AtomicFile
import cga.grading.findings.Findings
import cga.grading.findings.Graded
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.rubric.CheckGrade
import cga.grading.rubric.CheckState
import cga.grading.rubric.Grade
import cga.grading.rubric.Rubric
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import java.nio.file.Path
import kotlin.io.path.writeText

/**
 * `results.json` with the fields of Gradescope's autograder specification. A check that is open has neither score nor status, which is how
 * that format says neither passed nor failed; a submission that could not be graded has a score of 0, which the format needs, and says so.
 */
public object GradescopeResults {
    /** Writes the results of [submission] to [file]. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(submission: GradedSubmission, language: Language, file: Path) {
        val messages = Messages.of(language)
        val tests = submission.grade?.let { tests(it, messages) } ?: refused(submission, messages)
        write(file, results(submission.points ?: 0.0, submission.seconds, output(submission, messages), tests))
    }

    /** Writes what is known after [checks] have been measured: valid by itself, should there never be more. */
    public fun writePartial(checks: List<Measured>, rubric: Rubric, seconds: Double, language: Language, file: Path) {
        val messages = Messages.of(language)
        val grade = Grade.of(Findings(checks, emptyList(), emptyList(), emptyList(), emptyList()), rubric)
        write(file, results(grade.points, seconds, messages.text("gradescope.partial"), tests(grade, messages)))
    }

    private fun results(score: Double, seconds: Double, output: String, tests: List<JsonObject>) =
        buildJsonObject {
            put("score", score)
            put("execution_time", seconds.toLong())
            put("output", output)
            put("output_format", "text")
            put("visibility", "visible")
            // What the grader's own processes say is for the instructor.
            put("stdout_visibility", "hidden")
            put("tests", JsonArray(tests))
        }

    private fun output(submission: GradedSubmission, messages: Messages): String {
        val refusal = submission.refusal
        val parts =
            if (refusal != null) {
                val words = messages.of(refusal.reason)
                val blame = listOf(messages.text("page.no-points")).filter { submission.points == null }
                val logs = submission.outcome.facts.logs.map { "${cleanLine(it.title)}:\n${excerpt(it.text)}" }
                listOf(
                    words.title,
                    words.text,
                    clean(messages.say(refusal.detail.take(DETAIL))),
                    "${messages.text("page.hint")}: ${words.hint}",
                ) + blame +
                    logs
            } else {
                val open = submission.grade?.open ?: 0.0
                val mistakes = (submission.outcome as? Graded)?.findings?.mistakes.orEmpty().map { it.mistake }.distinct()
                listOf(messages.text("page.open", messages.number(open))).filter { open > 0 } +
                    mistakes.map { told(it, submission.grade, messages) }
            }
        val warning = listOf(messages.text("page.no-sandbox")).filterNot { submission.outcome.facts.isConfined }
        return (warning + parts).filter { it.isNotBlank() }.joinToString("\n\n").ifEmpty { score(submission, messages) }
    }

    private fun told(mistake: Mistake, grade: Grade?, messages: Messages): String {
        val words = messages.of(mistake)
        val seen = grade?.takeIf { mistake == Mistake.UNKNOWN }?.let { deviations(it, messages) }.orEmpty().map { "- $it" }
        return (listOf("${words.title}. ${words.text}") + seen + "${messages.text("page.hint")}: ${words.hint}").joinToString("\n")
    }

    private fun score(submission: GradedSubmission, messages: Messages) =
        messages.text("page.of", messages.number(submission.points ?: 0.0), messages.number(submission.rubric.total))

    private fun tests(grade: Grade, messages: Messages): List<JsonObject> =
        grade.tasks.flatMap { task ->
            task.checks.filter { it.maximum > 0 }.mapIndexed { i, check -> test(check, "${task.task}.${i + 1}", messages) }
        }

    private fun test(check: CheckGrade, number: String, messages: Messages): JsonObject {
        val words = messages.of(check.check)
        val points = check.points
        val cause = check.cause?.let(messages::of)
        val lines =
            listOf(messages.of(check.state), words.text, cause?.title.orEmpty(), clean(messages.say(check.message))) +
                if (points != null && points < check.maximum) listOf((cause ?: words).hint) else emptyList()
        return buildJsonObject {
            if (points != null) {
                put("score", points)
                put("max_score", check.maximum)
                put("status", if (points >= check.maximum) "passed" else "failed")
            }
            put(
                "name",
                if (points ==
                    null
                ) {
                    "${words.title} (${messages.of(CheckState.OPEN)}: ${messages.number(check.maximum)})"
                } else {
                    words.title
                },
            )
            common(number, lines.filter { it.isNotBlank() }.joinToString("\n"), check.check.task)
        }
    }

    private fun refused(submission: GradedSubmission, messages: Messages): List<JsonObject> {
        val refusal = submission.refusal ?: return emptyList()
        val words = messages.of(refusal.reason)
        val test =
            buildJsonObject {
                put("score", 0)
                put("max_score", submission.rubric.total)
                put("status", "failed")
                put("name", words.title)
                common("4", "${words.text}\n${words.hint}", refusal.reason.id)
            }
        return listOf(test)
    }

    private fun JsonObjectBuilder.common(number: String, output: String, tag: String) {
        put("name_format", "text")
        put("number", number)
        put("output", output)
        put("output_format", "text")
        put("tags", JsonArray(listOf(JsonPrimitive(tag))))
        put("visibility", "visible")
    }

    private fun write(file: Path, results: JsonObject) =
        AtomicFile.write(file) { it.writeText(Json.encodeToString(JsonElement.serializer(), results) + "\n") }

    private const val DETAIL = 4000
}

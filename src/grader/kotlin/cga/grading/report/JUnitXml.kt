package cga.grading.report

import cga.framework.AtomicFile
import cga.grading.rubric.CheckGrade
import cga.grading.rubric.CheckState
import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale
import javax.xml.stream.XMLOutputFactory
import javax.xml.stream.XMLStreamWriter

/**
 * The results as CI servers read them: a test suite for each submission, a test case for each check that counts. A check that is open is
 * skipped; a submission that was refused is one case that ended in an error.
 */
public object JUnitXml {
    /** Writes all [submissions] to [file]. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(submissions: List<GradedSubmission>, language: Language, file: Path) {
        val messages = Messages.of(language)
        val suites = submissions.map { Suite(it, messages) }
        AtomicFile.write(file) { temporary ->
            Files.newBufferedWriter(temporary).use { writer ->
                val xml = XMLOutputFactory.newInstance().createXMLStreamWriter(writer)
                xml.writeStartDocument("UTF-8", "1.0")
                xml.element("testsuites", counts("cga grade", suites.flatMap { it.cases }, suites.sumOf { it.submission.seconds })) {
                    suites.forEach { it.write(xml) }
                }
                xml.writeEndDocument()
                xml.close()
            }
        }
    }

    private class Case(
        val name: String,
        val kind: String?,
        val type: String = "",
        val message: String = "",
        val text: String = "",
    )

    private class Suite(
        val submission: GradedSubmission,
        messages: Messages,
    ) {
        val cases: List<Case> =
            submission.refusal?.let { refusal ->
                val words = messages.of(refusal.reason)
                listOf(Case("graded", "error", refusal.reason.id, words.title, "${words.text}\n${messages.say(refusal.detail)}"))
            } ?: submission.grade?.checks.orEmpty().filter { it.maximum > 0 }.map { case(it, messages) }

        fun write(xml: XMLStreamWriter) {
            val name = cleanLine(submission.name)
            xml.element("testsuite", counts(name, cases, submission.seconds)) {
                if (!submission.outcome.facts.isConfined) {
                    xml.element("properties", emptyList()) { xml.element("property", listOf("name" to "sandbox", "value" to "none")) {} }
                }
                for (case in cases) {
                    // One time for all checks of a submission: they are measured together.
                    xml.element(
                        "testcase",
                        listOf("name" to case.name, "classname" to name, "time" to "0"),
                    ) { case.kind?.let { result(xml, case, it) } }
                }
            }
        }

        private fun result(xml: XMLStreamWriter, case: Case, kind: String) {
            val type = listOf("type" to case.type).filter { kind != "skipped" }
            xml.element(kind, listOf("message" to case.message) + type) { xml.writeCharacters(clean(case.text)) }
        }

        private fun case(check: CheckGrade, messages: Messages): Case {
            val words = messages.of(check.check)
            val name = "${check.check.id} ${words.title}"
            val points = check.points
            return when {
                points == null -> Case(name, "skipped", message = messages.of(CheckState.OPEN), text = messages.say(check.message))
                points >= check.maximum -> Case(name, null)
                else -> {
                    val title = check.cause?.let { messages.of(it).title } ?: messages.of(check.state)
                    val hint = check.cause?.let { messages.of(it).hint } ?: words.hint
                    val score = messages.text("page.of", messages.number(points), messages.number(check.maximum))
                    Case(name, "failure", check.cause?.id ?: check.state.id, title, "$score\n${messages.say(check.message)}\n$hint")
                }
            }
        }
    }

    private fun counts(name: String, cases: List<Case>, seconds: Double): List<Pair<String, String>> =
        listOf("name" to name, "tests" to "${cases.size}") +
            listOf("failure" to "failures", "error" to "errors", "skipped" to "skipped").map { (kind, key) ->
                key to "${cases.count { it.kind == kind }}"
            } + ("time" to "%.3f".format(Locale.ROOT, seconds))

    private fun XMLStreamWriter.element(name: String, attributes: List<Pair<String, String>>, content: () -> Unit) {
        writeStartElement(name)
        for ((key, value) in attributes) writeAttribute(key, clean(value))
        content()
        writeEndElement()
    }
}

package cga.grading.report

import cga.framework.image.ImageData
import cga.framework.image.PngFile
import cga.grading.findings.Check
import cga.grading.findings.FailureReason
import cga.grading.findings.Measured
import cga.grading.rubric.Rubric
import cga.testing.Slow
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.w3c.dom.Element
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.readText

/** What other programs read: the table, JUnit's XML, Gradescope's JSON. */
@Slow
class TablesTest {
    @TempDir
    lateinit var folder: Path

    private lateinit var submissions: List<GradedSubmission>

    @BeforeEach
    fun grade() {
        submissions =
            listOf(
                Fakes.submission(folder, "anna", make = Fakes::mistaken),
                Fakes.submission(folder, "bo", "=HYPERLINK(\"http://x\",\"a\"), b", Fakes::perfect),
                Fakes.submission(folder, "cem", make = { Fakes.refused() }),
                Fakes.submission(folder, "dora", make = { Fakes.refused(FailureReason.NO_SANDBOX) }),
                Fakes.submission(folder, "eve", Fakes.HOSTILE, Fakes::hostile),
            )
    }

    @Test
    fun `the table is RFC 4180 and no cell is a formula`() {
        val file = folder.resolve("grades.csv")
        GradesCsv.write(submissions, listOf("+1+1"), file)
        val rows = parse(file.readText())
        assertEquals(setOf(rows[0].size), rows.map { it.size }.toSet())
        val column = rows[0].withIndex().associate { it.value to it.index }
        assertEquals(listOf("75.2", "100", "0", "", "2.7"), rows.drop(1).take(5).map { it[column.getValue("points")] })
        assertEquals(listOf("2", "0", "", "", "0"), rows.drop(1).take(5).map { it[column.getValue("open")] })
        assertEquals("'=HYPERLINK(\"http://x\",\"a\"), b", rows[2][0])
        assertEquals("'+1+1", rows[6][0])
        assertEquals("cone-inside-out phong-left-in more-lights-missing", rows[1][column.getValue("mistakes")])
        assertTrue(rows[4][column.getValue("reason")].startsWith("no-sandbox"))
        assertFalse(rows.flatten().any { it.isNotEmpty() && it[0] in "=+-@\t\r" })
    }

    /** A reader of RFC 4180, and of nothing laxer. */
    private fun parse(text: String): List<List<String>> {
        val field = Regex("\"((?:[^\"]|\"\")*)\"|([^\",\r\n]*)")
        val rows = mutableListOf(mutableListOf<String>())
        var at = 0
        while (at < text.length) {
            val match = field.matchAt(text, at)!!
            rows.last() += if (match.value.startsWith('"')) match.groupValues[1].replace("\"\"", "\"") else match.value
            at += match.value.length
            if (text.startsWith("\r\n", at)) {
                at += 2
                rows += mutableListOf<String>()
            } else {
                assertEquals(',', text[at])
                at++
            }
        }
        return rows.dropLast(1)
    }

    @Test
    fun `the XML is well-formed and counts what it holds`() {
        val file = folder.resolve("junit.xml")
        JUnitXml.write(submissions, Language.GERMAN, file)
        val root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile()).documentElement
        val suites = root.children("testsuite")
        assertEquals(5, suites.size)
        for (suite in suites + root) {
            val cases = if (suite == root) suites.flatMap { it.children("testcase") } else suite.children("testcase")
            assertEquals(suite.getAttribute("tests"), "${cases.size}")
            for ((kind, count) in listOf("failure" to "failures", "error" to "errors", "skipped" to "skipped")) {
                assertEquals(suite.getAttribute(count), "${cases.count { it.children(kind).isNotEmpty() }}", count)
            }
        }
        // Three mistakes, one check that differs and one that is not there; one is open.
        assertEquals(listOf("29", "5", "0", "1"), listOf("tests", "failures", "errors", "skipped").map { suites[0].getAttribute(it) })
        assertEquals(listOf("1", "0", "1", "0"), listOf("tests", "failures", "errors", "skipped").map { suites[2].getAttribute(it) })
        assertEquals("cone-inside-out", suites[0].children("testcase").flatMap { it.children("failure") }[1].getAttribute("type"))
        assertTrue(suites[4].getAttribute("name").startsWith("<img src=x"))
    }

    private fun Element.children(name: String) =
        (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>().filter { it.tagName == name }

    @Test
    fun `Gradescope's results have its fields and no others`() {
        for (submission in submissions) {
            val results = results(submission)
            val top = setOf("score", "execution_time", "output", "output_format", "visibility", "stdout_visibility", "tests")
            assertEquals(top, results.keys)
            for (test in results.getValue("tests").jsonArray.map { it.jsonObject }) {
                val always = setOf("name", "name_format", "number", "output", "output_format", "tags", "visibility")
                assertTrue(test.keys == always || test.keys == always + setOf("score", "max_score", "status")) { "${test.keys}" }
                assertTrue((test["status"]?.jsonPrimitive?.content ?: "passed") in setOf("passed", "failed"))
                assertEquals("text", test.getValue("output_format").jsonPrimitive.content)
            }
            assertEquals("hidden", results.getValue("stdout_visibility").jsonPrimitive.content)
        }
        assertEquals(listOf(75.2, 100.0, 0.0, 0.0, 2.7), submissions.map { results(it).getValue("score").jsonPrimitive.double })
        val anna = results(submissions[0])
        val earned = anna.getValue("tests").jsonArray.mapNotNull { it.jsonObject["score"]?.jsonPrimitive?.double }
        assertEquals(75.2, earned.sum(), 1e-9)
        assertEquals(28, earned.size)
        assertTrue("The cone is inside out" in anna.getValue("output").jsonPrimitive.content)
        assertTrue("not the fault" in results(submissions[3]).getValue("output").jsonPrimitive.content)
    }

    @Test
    fun `partial results are valid and say that they are partial`() {
        val file = folder.resolve("partial.json")
        GradescopeResults.writePartial(listOf(Measured(Check.DIFFUSE, 0.0, "")), Rubric.default(), 1.5, Language.ENGLISH, file)
        val results = Json.parseToJsonElement(file.readText()).jsonObject
        assertEquals(4.0, results.getValue("score").jsonPrimitive.double)
        assertEquals(1, results.getValue("tests").jsonArray.count { "score" in it.jsonObject })
        assertTrue("not finished" in results.getValue("output").jsonPrimitive.content)
    }

    private fun results(submission: GradedSubmission): JsonObject {
        val file = folder.resolve("results.json")
        GradescopeResults.write(submission, Language.ENGLISH, file)
        return Json.parseToJsonElement(file.readText()).jsonObject
    }

    @Test
    fun `a page with more pictures than it can carry draws them smaller and says so`() {
        val random = kotlin.random.Random(1)
        val noise = ImageData(1600, 900, random.nextBytes(4 * 1600 * 900))
        val outcome = Fakes.mistaken(folder)
        for (name in listOf("measured.png", "expected.png")) PngFile.write(noise, folder.resolve(name))
        SubmissionPage.write(Fakes.submission("big", folder, outcome), Language.ENGLISH)
        val page = folder.resolve(GradedSubmission.PAGE).readText()
        assertTrue(page.length < 6_000_000) { "${page.length}" }
        assertTrue("drawn smaller" in page)
    }
}

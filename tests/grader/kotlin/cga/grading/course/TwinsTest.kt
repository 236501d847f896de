package cga.grading.course

import cga.grading.findings.Graded
import cga.grading.findings.Likeness
import cga.grading.findings.Outcome
import cga.grading.findings.Part
import cga.grading.findings.RunFacts
import cga.grading.report.GradedSubmission
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText

/** Submissions with parts that are the same, through to the reports. */
@Slow
class TwinsTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = folder.resolve("out")
    private val fake = FakeGrader()

    /** Grades by the name: its letters are the Kotlin, the shaders and the drawn frames; who begins with `s` has the solution's shaders. */
    private val grader = GradeOne { submission, staged, listener ->
        val keys = Part.entries.zip(submission.name.toList()).associate { (part, letter) -> part to key(letter) }
        val likeness = Likeness(keys, if (submission.name[1] == 's') setOf(Part.SHADERS) else emptySet())
        val outcome: Outcome = fake.grade(submission, staged, listener)
        Graded((outcome as Graded).findings, RunFacts(likeness = likeness))
    }

    private fun key(letter: Char) = Likeness.keyOf(listOf("$letter".toByteArray()))

    private fun run(vararg names: String, out: Path = this.out, resume: Boolean = false): List<GradedSubmission> {
        val submissions = FakeGrader.submissions(folder.resolve("in"), *names.map { it to "right" }.toTypedArray())
        return FakeGrader
            .run(
                out,
                submissions,
                grader,
                resume,
            ).also { CourseReport.write(out, it, emptyList(), FakeGrader.settings.language) }
    }

    private fun page(name: String) = out.resolve("$name/report.html").readText()

    @Test
    fun `they are marked on both pages, on the contact sheet and in the table, and cost nothing`() {
        val graded = run("abc", "xbz", "asy", "qrt")
        assertEquals(listOf(100.0, 100.0, 100.0, 100.0), graded.map { it.points })
        assertEquals(mapOf("xbz" to setOf(Part.SHADERS), "asy" to setOf(Part.KOTLIN)), graded[0].twins)
        val mark = "The same in another submission, but for names and layout: "
        assertTrue("${mark}Kotlin, shaders." in page("abc") && "${mark}shaders." in page("xbz") && "${mark}Kotlin." in page("asy"))
        assertTrue("The same as in the solution, but for names and layout: shaders." in page("asy"))
        assertFalse("The same" in page("qrt"))
        // A page is for one student.
        assertFalse("xbz" in page("abc"))
        val sheet = out.resolve("index.html").readText()
        for (text in listOf("Same shaders: xbz", "Same Kotlin: abc", "Same shaders: the solution", "For a person to look at")) {
            assertTrue(text in sheet, text)
        }
        val table = out.resolve("grades.csv").readLines().map { it.split(',') }
        val column = table[0].indexOf("same_as")
        assertEquals(
            listOf("kotlin: asy; shaders: xbz", "kotlin: abc; shaders: the solution", "", "shaders: abc"),
            table.drop(1).map { it[column] },
        )
    }

    @Test
    fun `they are found again after an interruption, and among shards`() {
        run("abc", "qrt")
        assertFalse("The same" in page("abc"))
        assertEquals(
            listOf(listOf("xbz"), emptyList(), listOf("abc")),
            run("abc", "qrt", "xbz", resume = true).map { it.twins.keys.toList() },
        )
        assertTrue("The same" in page("abc"))
        run("uvc", out = folder.resolve("other"))
        val merged = ResultStore.open(folder.resolve("all"), resume = false).use { store ->
            Merge(store, FakeGrader.settings, FakeGrader.Silent).run(listOf(out, folder.resolve("other")))
        }
        val twins = merged.submissions.associate { it.folder.name to it.twins }
        assertEquals(mapOf("xbz" to setOf(Part.SHADERS), "uvc" to setOf(Part.CAPTURE)), twins["abc"])
        assertTrue("drawn frames." in folder.resolve("all/uvc/report.html").readText())
    }
}

package cga.grading.course

import cga.framework.InputError
import cga.grading.report.Language
import cga.grading.rubric.Rubric
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.appendText
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

@Slow
class CourseRunTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = folder.resolve("out")
    private val inputs get() = folder.resolve("in")

    private fun submissions(vararg what: Pair<String, String>) = FakeGrader.submissions(inputs, *what)

    @Test
    fun `whatever happens to one, the others are graded`() {
        val submissions =
            submissions(
                "a" to "right", "b" to "throws", "c" to "phong", "d" to "overflows", "e" to "loops", "f" to "no memory", "g" to "link",
                "h" to "right",
            )
        val graded = FakeGrader.run(out, submissions, FakeGrader())
        assertEquals(submissions.map { it.name }, graded.map { it.name })
        assertEquals(
            listOf(null, "internal", null, "internal", "timed-out", "internal", "internal", null),
            graded.map { it.refusal?.reason?.id },
        )
        assertEquals(listOf(100.0, null, 92.0, null, 0.0, null, null, 100.0), graded.map { it.points })
        for (submission in graded) {
            for (name in listOf(
                "report.html",
                "results.json",
                "outcome.json",
            )) {
                assertTrue(submission.folder.resolve(name).exists()) { name }
            }
        }
        assertTrue("the grader broke" in out.resolve("b/report.html").readText())
        assertFalse(out.resolve("g/measured.png").exists())
    }

    @Test
    fun `nothing but the named pictures is kept`() {
        FakeGrader.run(out, submissions("a" to "litters"), FakeGrader())
        val kept = setOf(".report", "findings.json", "outcome.json", "report.html", "results.json")
        assertEquals(kept, out.resolve("a").listDirectoryEntries().map { it.name }.toSet())
    }

    @Test
    fun `to resume repeats only what changed, and what failed through no fault of its own`() {
        val submissions = submissions("a" to "right", "b" to "loops", "c" to "throws")
        FakeGrader.run(out, submissions, FakeGrader())
        val page = out.resolve("a/report.html")
        val written = page.getLastModifiedTime()
        inputs.resolve("b/what").writeText("phong")
        val again = FakeGrader()
        val graded = FakeGrader.run(out, submissions, again, resume = true)
        assertEquals(listOf("b", "c"), again.graded.sorted())
        assertEquals(listOf(100.0, 92.0, null), graded.map { it.points })
        assertEquals(written, page.getLastModifiedTime())
    }

    @Test
    fun `another rubric or language changes points and pages without measuring again`() {
        val submissions = submissions("a" to "phong")
        FakeGrader.run(out, submissions, FakeGrader())
        val file = folder.resolve("rubric.json")
        file.writeText(
            Rubric.defaultBytes().decodeToString().replace("\"4.7.halfvector\": {\"points\": 8", "\"4.7.halfvector\": {\"points\": 2"),
        )
        val again = FakeGrader()
        val settings = CourseSettings(Rubric.read(file), Language.GERMAN)
        val graded = FakeGrader.run(out, submissions, again, resume = true, settings = settings)
        assertEquals(listOf(92.0, 94.0), listOf(graded[0].points, graded[0].rubric.total))
        assertTrue(again.graded.isEmpty())
        assertTrue("Noch Phong" in out.resolve("a/report.html").readText())
        val edition = CourseSettings(Rubric.default(), Language.ENGLISH, edition = "2022")
        FakeGrader.run(out, submissions, again, resume = true, settings = edition)
        assertEquals(1, again.graded.size)
    }

    @Test
    fun `a damaged result is made again`() {
        val submissions = submissions("a" to "right", "b" to "right", "c" to "right")
        FakeGrader.run(out, submissions, FakeGrader())
        out.resolve("a/outcome.json").appendText("}")
        out.resolve("b/findings.json").deleteExisting()
        val again = FakeGrader()
        assertEquals(listOf(100.0, 100.0, 100.0), FakeGrader.run(out, submissions, again, resume = true).map { it.points })
        assertEquals(listOf("a", "b"), again.graded.sorted())
    }

    @Test
    fun `results are not overwritten unasked, nor other things, and not by two at once`() {
        FakeGrader.run(out, submissions("a" to "right"), FakeGrader())
        assertTrue("--resume" in assertThrows<InputError> { ResultStore.open(out, resume = false) }.message.orEmpty())
        assertThrows<InputError> { ResultStore.open(inputs, resume = true) }
        assertThrows<InputError> { ResultStore.open(inputs.resolve("a/what"), resume = false) }
        ResultStore.open(out, resume = true).use {
            assertTrue("another" in assertThrows<InputError> { ResultStore.open(out, resume = true) }.message.orEmpty())
        }
    }

    @Test
    fun `what vanishes on the way is its own failure`() {
        val submissions = submissions("a" to "right", "b" to "right")
        inputs.resolve("b/what").deleteExisting()
        assertEquals(listOf(100.0, null), FakeGrader.run(out, submissions, FakeGrader()).map { it.points })
    }

    @Test
    fun `there are partial results for Gradescope before the first check and whole ones at the end`() {
        val file = folder.resolve("results.json")
        var before = ""
        val grader = FakeGrader { before = file.readText() }
        val settings = CourseSettings(Rubric.default(), Language.ENGLISH, gradescope = file)
        FakeGrader.run(out, submissions("a" to "right"), grader, settings = settings)
        assertTrue("not finished" in before)
        assertTrue("\"score\":100.0" in file.readText() && "not finished" !in file.readText())
    }

    @Test
    fun `as many run at once as there are jobs, and no more`() {
        val running = AtomicInteger()
        val most = AtomicInteger()
        val two = CountDownLatch(2)
        val grader = FakeGrader {
            most.accumulateAndGet(running.incrementAndGet(), ::maxOf)
            // The first waits for the second: a single worker would wait in vain.
            two.countDown()
            two.await(10, SECONDS)
            running.decrementAndGet()
        }
        FakeGrader.run(out, submissions("a" to "right", "b" to "right", "c" to "right"), grader)
        assertEquals(2, most.get())
    }
}

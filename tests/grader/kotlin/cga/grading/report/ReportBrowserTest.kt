package cga.grading.report

import cga.grading.course.CourseReport
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import cga.testing.Browser
import cga.testing.Slow
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** The pages as a student and a grader have them: opened from files in a browser, used with mouse and keys. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class ReportBrowserTest {
    private lateinit var folder: Path
    private lateinit var browser: Browser

    @BeforeAll
    fun write(
        @TempDir temporary: Path,
    ) {
        folder = temporary
        browser = Browser.openOrSkip()
        val submissions =
            listOf(
                Fakes.submission(folder, "anna", "Anna", Fakes::mistaken),
                Fakes.submission(folder, "bo", "Bo", Fakes::perfect),
                Fakes.submission(folder, "cem", make = { Fakes.refused() }),
                Fakes.submission(folder, "dora", make = { Fakes.refused(FailureReason.NO_SANDBOX) }),
                Fakes.submission(folder, "eve", Fakes.HOSTILE, Fakes::hostile),
            )
        for (submission in submissions) {
            (submission.outcome as? Graded)?.let { Thumbnail.write(it.findings, submission.folder) }
            SubmissionPage.write(submission, Language.GERMAN)
        }
        CourseReport.write(folder, submissions, listOf("Finn"), Language.GERMAN)
    }

    @AfterAll
    fun close() = browser.close()

    private fun text(expression: String) = browser.evaluate(expression).jsonPrimitive.content

    private fun number(expression: String) = browser.evaluate(expression).jsonPrimitive.double

    private fun open(name: String, width: Int = 1280, isDark: Boolean = false) = browser.open(folder.resolve(name), width, 900, isDark)

    @Test
    fun `no page complains, loads anything, or is wider than a telephone`() {
        for (page in listOf("anna", "bo", "cem", "dora", "eve").map { "$it/report.html" } + "index.html") {
            for (dark in listOf(false, true)) {
                open(page, 390, dark)
                assertEquals(390.0, number("document.documentElement.scrollWidth"), page)
                assertEquals(if (dark) "rgb(20, 22, 26)" else "rgb(244, 245, 247)", text("getComputedStyle(document.body).backgroundColor"))
                assertEquals(emptyList<String>(), browser.complaints, page)
                assertEquals(listOf(folder.resolve(page).toUri().toString()), browser.requests)
                assertEquals("de", text("document.documentElement.lang"))
            }
        }
    }

    @Test
    fun `a hostile submission is text and nothing else`() {
        for (page in listOf("eve/report.html", "index.html")) {
            open(page)
            assertEquals(0.0, number("document.querySelectorAll('[onload], [onerror], [src=x]').length"))
            assertTrue("<img src=x onerror=alert(1)>" in text("document.querySelector('main').textContent"))
        }
        open("eve/report.html")
        assertTrue("[…]" in text("[...document.querySelectorAll('pre')].map((pre) => pre.textContent).join(' ')"))
        assertTrue(number("Math.max(...[...document.querySelectorAll('pre')].map((pre) => pre.textContent.length))") < 13_000)
        assertTrue("gone.png war nicht lesbar" in text("document.querySelector('main').textContent"))
    }

    @Test
    fun `the slider lays the pictures upon each other and speaks the page's language`() {
        open("anna/report.html")
        assertEquals("Umschalten Blinken", text("[...document.querySelectorAll('.tools button')].map((b) => b.textContent).join(' ')"))
        assertEquals(
            "Trennlinie zwischen Ihres links und erwartet rechts",
            text("document.querySelector('.stage input').getAttribute('aria-label')"),
        )
        val cut = "document.querySelector('.slider').style.getPropertyValue('--cut')"
        val before = text(cut)
        browser.drag(browser.pointOf(".stage", 0.5), browser.pointOf(".stage", 0.25))
        assertNotEquals(before, text(cut))
        assertTrue(text(cut).removeSuffix("%").toDouble() < 30) { text(cut) }
    }

    @Test
    fun `the page shows points, mistake, hint, curves and lights`() {
        open("anna/report.html")
        assertEquals("75,2 / 100", text("document.querySelector('.score p').textContent"))
        assertEquals("29", text("`${'$'}{document.querySelectorAll('.points .what').length}`"))
        assertEquals("Der Kegel ist umgestülpt", text("document.querySelector('.case h2').textContent"))
        assertEquals("3", text("`${'$'}{document.querySelectorAll('.hint').length}`"))
        assertEquals("2", text("`${'$'}{document.querySelectorAll('.curve svg .measured[d*=L]').length}`"))
        assertEquals("4", text("`${'$'}{document.querySelectorAll('.lights img').length}`"))
        assertTrue(text("document.querySelector('.part:last-of-type').textContent").contains("Kotlin 2.2.21, Sprachstufe 2.0"))
    }

    @Test
    fun `the sheet sorts by a click, what has no value last`() {
        open("index.html")
        val names = "[...document.querySelectorAll('.sheet tbody tr')].map((r) => r.children[1].textContent.slice(0, 4)).join(' ')"
        assertEquals("Anna Bo cem dora <img Finn", text(names))
        browser.click(".sheet th:nth-child(3) button")
        assertEquals("Bo Anna <img cem dora Finn", text(names))
        browser.click(".sheet th:nth-child(3) button")
        assertEquals("cem <img Anna Bo dora Finn", text(names))
        assertEquals("ascending", text("document.querySelector('.sheet th:nth-child(3)').getAttribute('aria-sort')"))
        browser.click(".sheet th:nth-child(2) button")
        assertEquals("<img Anna Bo cem dora Finn", text(names))
        browser.click(".sheet th:nth-child(2) button")
        assertEquals("Finn dora cem Bo Anna <img", text(names))
        assertEquals(
            "anna/report.html",
            text("[...document.querySelectorAll('.sheet a')].find((a) => a.textContent === 'Anna').getAttribute('href')"),
        )
    }
}

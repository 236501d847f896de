package cga.imaging.report

import cga.imaging.Comparison
import cga.imaging.Severity
import cga.testing.Browser
import cga.testing.Slow
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** The page as a reader has it: opened from a file in a browser, used with mouse and keys. */
@Slow
class HtmlReportBrowserTest {
    @TempDir
    lateinit var folder: Path

    private lateinit var browser: Browser
    private val hostile = "<img src=x onerror=alert(1)> \"' onload=alert(2) x='"

    @BeforeEach
    fun open() {
        browser = Browser.openOrSkip()
        val before = gradient(120, 68)
        val after = before.with(70, 30, 20)
        val cases =
            listOf(
                caseOf(before, before, "same", Severity.PASS),
                caseOf(before, after, "bytes"),
                ReportCase("floats", Severity.WARN, listOf("a message"), Comparison(before.floats(3f), after.floats(3f))),
                ReportCase(hostile, Severity.FAIL, listOf(hostile), comparison = null),
            )
        val file = folder.resolve("report.html")
        HtmlReport.write("A report", cases, file)
        browser.open(file, 1280, 800)
    }

    /** Whatever a test did: the page made no fuss and asked for nothing but itself. */
    @AfterEach
    fun close() {
        browser.use {
            assertEquals(listOf<String>(), it.complaints)
            assertEquals(listOf("${folder.resolve("report.html").toUri()}"), it.requests)
        }
    }

    private fun number(expression: String) = browser.evaluate(expression).jsonPrimitive.double

    private fun text(expression: String) = browser.evaluate(expression).jsonPrimitive.content

    @Test
    fun `every picture is loaded and has a place`() {
        val unfolded = "document.querySelectorAll('details').forEach((d) => { d.open = true; })"
        browser.evaluate("(async () => { $unfolded; await Promise.all([...document.images].map((i) => i.decode())); })()")
        assertEquals(0.0, number("[...document.images].filter((i) => i.naturalWidth === 0 || i.width === 0).length"))
        // Two each and a map on the page, enlarged ones, and what shows them again.
        assertTrue(number("document.images.length") > 16)
        assertTrue(number("[...document.images].filter((i) => i.id && !i.alt).length") == 0.0)
    }

    @Test
    fun `the mouse moves the divider, and the picture is cut there`() {
        val before = screenshotHash()
        browser.drag(browser.pointOf(".stage", 0.5), browser.pointOf(".stage", 0.4), browser.pointOf(".stage", 0.25))
        assertEquals(25.0, number("document.querySelector('.stage input').value"), 1.0)
        val cut = "getComputedStyle(document.querySelectorAll('.stage img')[1]).clipPath"
        assertTrue(text(cut).contains("75")) { text(cut) }
        assertEquals(
            25.0,
            number("100 * (document.querySelector('.stage .line').offsetLeft + 1) / document.querySelector('.stage').clientWidth"),
            1.0,
        )
        assertNotEquals(before, screenshotHash())
    }

    @Test
    fun `so do the arrow keys, and it is told in words`() {
        browser.evaluate("document.querySelector('.stage input').focus()")
        repeat(3) { browser.key("ArrowRight", 39) }
        val value = number("document.querySelector('.stage input').value")
        assertTrue(value in 51.0..60.0) { "$value" }
        assertTrue(
            text("document.querySelector('.stage input').getAttribute('aria-valuetext')").startsWith("Expected ${Math.round(value)} %"),
        )
        browser.key("Home", 36)
        assertEquals(0.0, number("document.querySelector('.stage input').value"))
        assertEquals("true false", text("['left', 'right'].map((s) => document.querySelector('.tag.' + s).hidden).join(' ')"))
    }

    @Test
    fun `flip shows one picture, then the other, and blink goes on by itself until stopped`() {
        fun value() = number("document.querySelector('.stage input').value")
        browser.click(".tools button:nth-child(1)")
        val first = value()
        browser.click(".tools button:nth-child(1)")
        assertEquals(setOf(0.0, 100.0), setOf(first, value()))
        browser.click(".tools button:nth-child(2)")
        val pressed = "document.querySelector('.tools button:nth-child(2)').getAttribute('aria-pressed')"
        assertEquals("true", text(pressed))
        val start = value()
        assertTrue(
            browser
                .evaluate(
                    "new Promise((done) => { const wait = () => document.querySelector('.stage input').value != $start" +
                        " ? done(true) : setTimeout(wait, 20); wait(); })",
                ).jsonPrimitive.boolean,
        )
        browser.click(".tools button:nth-child(2)")
        assertEquals("false", text(pressed))
    }

    @Test
    fun `the difference is painted, exact, and amplified as chosen`() {
        // Read from a copy: a canvas that a page draws once is not made for being read.
        fun color(canvas: Int, x: Int, y: Int) =
            browser
                .evaluate(
                    "(() => { const copy = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });" +
                        " copy.drawImage(document.querySelectorAll('canvas')[$canvas], -$x, -$y);" +
                        " return [...copy.getImageData(0, 0, 1, 1).data]; })()",
                ).jsonArray
                .map { it.jsonPrimitive.int }
        awaitPainted()
        assertEquals(listOf(20, 0, 0, 255), color(0, 70, 30))
        assertEquals(listOf(0, 0, 0, 255), color(0, 71, 30))
        // Enlarged: 24 pixels about it, so it is the twelfth.
        assertEquals(listOf(20, 0, 0, 255), color(1, 12, 12))
        assertEquals("brightness(4)", text("document.querySelector('canvas').style.filter"))
        browser.evaluate(
            "(() => { const s = document.querySelector('.gain select'); s.value = '64'; s.dispatchEvent(new Event('change')); })()",
        )
        assertEquals("brightness(64)", text("document.querySelectorAll('canvas')[1].style.filter"))
    }

    private fun awaitPainted() {
        browser.evaluate("Promise.all([...document.images].map((i) => i.decode())).then(() => new Promise((done) => setTimeout(done, 50)))")
    }

    @Test
    fun `the filter hides what is not asked for, in the list and below`() {
        fun shown() = text(
            "[...document.querySelectorAll('section, tbody tr')].filter((e) => e.offsetHeight > 0).map((e) => e.dataset.severity).join(' ')",
        )
        assertEquals("fail fail warn pass fail fail warn pass", shown())
        browser.click(".filter .warn input")
        assertEquals("warn warn", shown())
        browser.click(".filter .all input")
        assertEquals(8, shown().split(' ').size)
    }

    @Test
    fun `a link unfolds its case`() {
        assertEquals("false", text("document.querySelector('#case-4 details').open"))
        browser.click("a[href='#case-4']")
        assertTrue(
            browser
                .evaluate(
                    "new Promise((done) => setTimeout(() => done(document.querySelector('#case-4 details').open), 100))",
                ).jsonPrimitive.boolean,
        )
    }

    @Test
    fun `a hostile name is text and nothing else`() {
        assertEquals(hostile, text("document.querySelector('#case-2 h2').textContent"))
        assertEquals(0.0, number("document.querySelectorAll('[onload], [onerror]').length"))
    }

    @Test
    fun `it fits a telephone and takes on a dark scheme`() {
        browser.open(folder.resolve("report.html"), 390, 800, isDark = true)
        assertEquals(390.0, number("document.documentElement.scrollWidth"))
        assertEquals("rgb(20, 22, 26)", text("getComputedStyle(document.body).backgroundColor"))
    }

    private fun screenshotHash() = browser.screenshot().contentHashCode()
}

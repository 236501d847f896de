package cga.imaging.report

import cga.framework.InputError
import cga.framework.image.FloatImage
import cga.imaging.Comparison
import cga.imaging.FloatPicture
import cga.imaging.Pixel
import cga.imaging.Severity
import cga.imaging.values
import cga.imaging.written
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import java.util.Base64
import kotlin.random.Random

@Slow
class HtmlReportTest {
    @TempDir
    lateinit var folder: Path

    private val picture = gradient(48, 27)
    private val changed = picture.with(20, 10, 40)

    private fun html(vararg cases: ReportCase, title: String = "A report"): String {
        val file = folder.resolve("report.html")
        HtmlReport.write(title, cases.toList(), file)
        assertEquals(listOf(file), Files.list(folder).use { it.toList() })
        return Files.readString(file)
    }

    private fun count(part: String, text: String) = Regex.fromLiteral(part).findAll(text).count()

    @Test
    fun `text is escaped wherever it stands`() {
        val hostile = "<script>alert(1)</script> \"' onload=alert(2) </style> &amp;"
        val case = ReportCase(hostile, Severity.FAIL, listOf(hostile), Comparison(picture, changed), listOf(hostile to hostile))
        val html = html(case, title = hostile)
        assertEquals(1, count("<script", html))
        assertEquals(1, count("</style", html))
        // In text a quote is harmless; in an attribute it would end the value.
        for (attribute in Regex(" (?:alt|aria-label)=\"([^\"]*)\"([^>]*)").findAll(html)) {
            assertFalse("onload" in attribute.groupValues[2]) { attribute.value.take(300) }
        }
        assertTrue("&lt;script&gt;alert(1)&lt;/script&gt;" in html)
        assertTrue("&amp;amp;" in html)
    }

    @Test
    fun `nothing is loaded from anywhere`() {
        val html = html(caseOf(picture, changed), caseOf(picture, picture))
        for (reference in listOf("http:", "https:", "//www", "url(", "@import", "<link", "<iframe")) {
            assertFalse(
                reference in html,
            ) { reference }
        }
        val sources = Regex(" (?:src|href)=\"([^\"]{0,12})").findAll(html).map { it.groupValues[1] }.toList()
        assertTrue(sources.all { it.startsWith("data:image/") || it.startsWith("#case-") }) { "$sources" }
    }

    @Test
    fun `only its own style and script are allowed`() {
        val html = html(caseOf(picture, changed))
        val policy = Regex("Content-Security-Policy\"|content=\"(default-src[^\"]*)\"").findAll(html).map { it.groupValues[1] }.first {
            it !=
                ""
        }
        assertTrue(policy.startsWith("default-src 'none'; img-src data:; ")) { policy }
        for (kind in listOf("style", "script")) {
            val text = html.substringAfter("<$kind>").substringBefore("</$kind>")
            val hash = Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(text.toByteArray()))
            assertTrue("$kind-src 'sha256-$hash'" in policy) { "$kind: $hash is not in $policy" }
        }
        // It would be ignored under this policy.
        assertFalse(" style=\"" in html)
    }

    @Test
    fun `of pictures that are the same one is on the page`() {
        val html = html(caseOf(picture, picture, severity = Severity.PASS))
        assertEquals(1, count("data:image/png", html))
        assertTrue("Expected and actual are identical" in html)
        assertFalse("<canvas" in html)
    }

    @Test
    fun `a case without a comparison shows why, and the picture that there is`() {
        val bare = ReportCase("gone", Severity.FAIL, listOf("the render failed"), comparison = null)
        val alone = ReportCase("new", Severity.FAIL, listOf("there is no golden image"), comparison = null, picture = picture)
        val html = html(bare, alone)
        assertTrue("the render failed" in html && "there is no golden image" in html)
        assertEquals(1, count("data:image/png", html))
        assertTrue("nothing to compare it to" in html)
    }

    @Test
    fun `what failed comes first, and otherwise the order stays`() {
        val order = listOf("a" to Severity.PASS, "b" to Severity.FAIL, "c" to Severity.WARN, "d" to Severity.FAIL)
        val html = html(*order.map { (name, severity) -> caseOf(picture, picture, name, severity) }.toTypedArray())
        assertEquals(listOf("b", "d", "c", "a"), Regex("<h2><bdi>(.*?)</bdi>").findAll(html).map { it.groupValues[1] }.toList())
        for (words in listOf("all 4", "2 failed", "1 warning", "1 passed")) assertTrue(words in html) { words }
        assertEquals(3, count("<details open", html))
    }

    @Test
    fun `a report of nothing says so`() {
        assertTrue("There are no cases" in html())
    }

    @Test
    fun `a difference is told in the units of the picture`() {
        val html = html(caseOf(picture, changed))
        val before = values(picture, Pixel(20, 10))
        for (words in listOf(
            "1 of 1,296 (0.08 %)",
            "red 40/255 · green 0 · blue 0",
            "Worst pixel, at 20, 10",
            "+40  0  0",
            written(before),
        )) {
            assertTrue(words in html) { words }
        }
    }

    @Test
    fun `floats are told unclamped, and their exposure is`() {
        val (dark, bright) = picture.floats(10f) to changed.floats(10f)
        val html = html(ReportCase("floats", Severity.FAIL, listOf(), Comparison(dark, bright)))
        // The brightest of the hundredth part of the pixels are about 10·200/255 = 7.8, which three stops bring below 1.
        assertTrue("exposure of −3 stops" in html)
        assertTrue(written(values(bright, Pixel(20, 10))) in html)
    }

    @Test
    fun `a difference that cannot be drawn is not passed over`() {
        val dark = picture.floats(1f)
        val faint = FloatPicture.opaque(FloatImage(48, 27, FloatArray(4 * 48 * 27) { dark.image.rgba[it] + if (it == 400) 1e-5f else 0f }))
        val html = html(ReportCase("faint", Severity.FAIL, listOf(), Comparison(dark, faint)))
        assertTrue("differ by too little" in html)
        assertTrue("1 of 1,296" in html)
    }

    @Test
    fun `pictures that would take too much are drawn smaller, but their enlarged parts are not`() {
        // Incompressible: 3 bytes a pixel, and a third more as text; 4.8 MB each.
        val random = Random(1)
        val noise = picture(1200, 1000) { _, _, _ -> random.nextInt(256) }
        val case = caseOf(noise, noise.noisy(3, random))
        val html = html(case)
        assertTrue(html.length < 10_000_000) { "${html.length} characters" }
        assertTrue("drawn at 1/2 of their size" in html)
        assertTrue("width=\"24\"" in html)
    }

    @Test
    fun `a page that cannot be written is refused before the work`() {
        val file = folder.resolve("missing").resolve("report.html")
        val message = assertThrows<InputError> { HtmlReport.write("A report", listOf(), file) }.message.orEmpty()
        assertTrue("$file" in message) { message }
    }
}

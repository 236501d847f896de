package cga.cli.lab

import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.Slow
import com.github.ajalt.clikt.core.parse
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** `cga accuracy`: what it writes. The times are no test's business. */
@Slow
class AccuracyCommandTest {
    @TempDir
    private lateinit var folder: Path
    private val document by lazy { folder.resolve("doc.md") }

    @Test
    fun `the document gets tables, plots and what they were measured on, and keeps its text`() {
        Offscreen.openOrSkip().close()
        document.writeText(DOCUMENT)
        AccuracyCommand().parse(listOf("--runs", "1", "--size", "64x36", "--only", "choices", "--out", "$document"))
        val text = document.readText()
        assertEquals(DOCUMENT, text.replace(Regex("(?s)(<!-- (?:table|plot):choices -->\n).*?(<!-- end -->)"), "$1$2"))
        for (group in GROUPS) assertTrue("#### $group" in text) { "$group is missing in\n$text" }
        for (row in ROWS) assertTrue("\n| $row |" in text) { "$row is missing in\n$text" }
        assertTrue(Regex("""llvmpipe .*JDK .*1 runs, .*Load average.*No GPU was measured""") in text) { text }
        assertFalse("NaN" in text || "Infinity" in text) { text }
        for (plot in PLOTS) assertPlot(plot, text)
        assertEquals(listOf("doc.md", "images"), folder.listDirectoryEntries().map { it.name }.sorted())
    }

    @Test
    fun `one part alone leaves the others`() {
        document.writeText(DOCUMENT.replace("<!-- table:choices -->\n", "<!-- table:choices -->\nold\n"))
        AccuracyCommand().parse(listOf("--only", "matrices", "--out", "$document"))
        val text = document.readText()
        assertTrue("| operation | cases | GLM float |" in text) { text }
        assertTrue("<!-- table:choices -->\nold\n<!-- end -->" in text) { text }
        assertEquals(listOf(document), folder.listDirectoryEntries())
    }

    @Test
    fun `a document without a marker is refused before anything is measured, and stays`() {
        document.writeText("no markers\n")
        val process = CgaProcess.cga("accuracy", "--out", "$document", directory = folder)
        assertEquals(2, process.exitCode, "$process")
        assertTrue("<!-- table:" in process.err && "$document" in process.err && "\tat " !in process.err, "$process")
        assertEquals("no markers\n", document.readText())
        assertEquals(listOf(document), folder.listDirectoryEntries())
    }

    @Test
    fun `bad options and documents that cannot be end with 2 and one message`() {
        val bad = listOf(listOf("--runs", "0"), listOf("--only", "nothing"), listOf("--size", "0x9"), listOf("--out", "$folder/none.md"))
        folder.resolve("deep").createDirectory()
        for (args in bad + listOf(listOf("--out", "$folder/deep"))) {
            val process = CgaProcess.cga("accuracy", *args.toTypedArray(), directory = folder)
            assertEquals(2, process.exitCode, "$args: $process")
            assertTrue("\tat " !in process.err, "$args: $process")
        }
    }

    private fun assertPlot(
        name: String,
        text: String,
    ) {
        val svg = folder.resolve("images/$name.svg")
        assertTrue(svg.exists() && "</svg>" in svg.readText(), "$svg")
        assertFalse("<text" in svg.readText(), "a text in $svg looks different where its font is missing")
        val picture = ImageIO.read(folder.resolve("images/$name.png").toFile())
        assertTrue(picture.width == 1800 && picture.height == 1120)
        assertTrue("(images/$name.svg)" in text, text)
    }

    private companion object {
        const val DOCUMENT =
            "# Title\n\n<!-- table:matrices -->\n<!-- end -->\n\nText.\n\n" +
                "<!-- plot:choices -->\n<!-- end -->\n<!-- table:choices -->\n<!-- end -->\n\nEnd.\n"
        val GROUPS =
            listOf("Lighting", "Colour target", "Texture filter of llvmpipe", "Antialiasing", "The reference", "Matrices: normal matrix")
        val ROWS =
            listOf("ours", "toLight per fragment", "Phong", "RGBA16F", "4 samples of OpenGL", "reference, 4×4", "JOML float (fastmath)")
        val PLOTS = listOf("accuracy-drawing", "accuracy-antialiasing", "accuracy-matrices")
    }
}

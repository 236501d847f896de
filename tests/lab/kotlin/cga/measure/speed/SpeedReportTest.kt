package cga.measure.speed

import cga.framework.Home
import cga.measure.MarkedDocument
import cga.measure.Sample
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.math.pow

class SpeedReportTest {
    @Test
    fun `a sample knows its middle and its ends`() {
        val sample = Sample(listOf(5.0, 1.0, 3.0))
        assertEquals(listOf(1.0, 3.0, 5.0), listOf(sample.lowest, sample.median, sample.highest))
    }

    @Test
    fun `a table says the median with its spread, and what was not measured`() {
        val rows = listOf(SpeedRow("a", Sample(listOf(1.0, 2.0, 4.5)), null), SpeedRow("b", Sample(listOf(0.125)), Sample(listOf(1234.0))))
        val markdown = SpeedTable("T", "note", "what", listOf("ms", "n"), rows).toMarkdown()
        assertTrue("| what | ms | n |\n|---|---:|---:|\n| a | 2 (1–4.50) | – |\n| b | 0.125 | 1234 |" in markdown) { markdown }
    }

    @Test
    fun `a goal is met up to its limit`() {
        assertTrue(Goal("x", 1.03, 1.03, "times").isMet)
        assertFalse(Goal("x", 1.031, 1.03, "times").isMet)
        assertTrue("Measured: 2 s, **not met**" in "${Goal("x", 2.0, 1.5, "s")}")
    }

    @Test
    fun `growth is the power of a power law`() {
        for (power in listOf(0.0, 1.0, 1.7)) {
            val points = listOf(100, 1000, 10_000).map { it to 3.5 * it.toDouble().pow(power) }
            assertEquals(power, SubmissionPart.growth(points), 1e-12)
        }
    }

    @Test
    fun `frame times survive the way to another process`() {
        val times = FrameTimes(doubleArrayOf(1.5, 2.25), doubleArrayOf(0.5, 1e-3), doubleArrayOf(0.0, 1240.0))
        val back = FrameTimes.parse("$times")
        assertEquals("$times", "$back")
        assertEquals(listOf(1.5, 2.25), back.clock.asList())
    }

    @Test
    fun `the document has a place for every part`() {
        val document = MarkedDocument.read(Home.resolve("docs/performance.md"))
        for (part in SpeedReport.parts + "machine") document.require("table:$part")
    }

    @Test
    fun `a timeline's bars begin and end where their spans do`(
        @TempDir folder: Path,
    ) {
        TimelinePicture("t", "Spans", listOf("first" to 0.0..50.0, "second" to 50.0..100.0)).write(folder)
        val bars = Regex("""<rect x="([\d.]+)" y="\d+" width="([\d.]+)"""").findAll(folder.resolve("t.svg").readText())
        val (first, second) = bars.map { it.groupValues[1].toDouble() to it.groupValues[2].toDouble() }.toList()
        assertEquals(first.second, second.second, 0.11)
        assertEquals(first.first + first.second, second.first, 0.11)
    }
}

package cga.imaging.report

import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.brief
import cga.imaging.flip.FlipMap
import cga.imaging.grouped
import cga.imaging.percent
import cga.imaging.step
import cga.imaging.written
import kotlinx.html.div
import kotlinx.html.stream.createHTML
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What the report's pictures, bars and numbers are made of. */
class ReportPartsTest {
    @Test
    fun `every pixel is in one bar, that of its largest channel`() {
        val before = picture(10, 1) { _, _, _ -> 100 }
        val change = listOf(0, 1, 2, 3, 4, 5, 16, 17, 128, 129)
        val after = picture(10, 1) { x, _, channel -> if (channel == 2) (100 + change[x]) else 100 }
        val bars = differenceBars(Comparison(before, after))
        assertEquals(listOf(1, 1, 1, 2, 1, 1, 1, 0, 1, 1), bars.map { it.count })
        assertEquals(listOf("0", "1", "2", "3–4", "5–8", "9–16", "17–32", "33–64", "65–128", "> 128"), bars.map { it.label })
        assertEquals(
            listOf(1, 2, 0, 0, 1, 0, 0, 0, 0, 1),
            flipBars(FlipMap(5, 1, floatArrayOf(0f, 0.001f, 0.01f, 0.1f, 1f))).map { it.count },
        )
    }

    @Test
    fun `a histogram's bars are taller for more, by the logarithm`() {
        val html = createHTML(prettyPrint = false).div {
            histogram("Pixels", "error", listOf(Bar("a", 1), Bar("b", 0), Bar("c", 100), Bar("d", 10_000)))
        }
        val heights = Regex("<rect[^>]* height=\"(\\d+)\"").findAll(html).map { it.groupValues[1].toInt() }.toList()
        assertEquals(3, heights.size)
        // Two decades either way; a whole unit less or more from rounding each.
        assertEquals((heights[1] - heights[0]).toDouble(), (heights[2] - heights[1]).toDouble(), 1.0)
        assertTrue(heights[0] > 0) { "one pixel is not to be overlooked: $heights" }
    }

    @Test
    fun `floats are drawn at the brightest whole stop that clamps few`() {
        assertNull(Display.of(gradient(8, 8)).exposure)
        val white = picture(16, 16) { _, _, _ -> 255 }
        for ((value, stops) in listOf(1f to 0, 1.01f to -1, 4f to -2, 0.5f to 1, 0.3f to 1, 0f to 0)) {
            assertEquals(stops, Display.of(white.floats(value)).exposure, "$value")
        }
        val drawn = Display.of(white.floats(3f)).let { it.draw(white.floats(3f)).rgba[0].toInt() and 0xFF }
        assertEquals(191, drawn, "3 at −2 stops is 0.75 of 255, which is 191.25")
    }

    @Test
    fun `one bright pixel does not darken the picture`() {
        val lamp = picture(16, 16) { x, y, _ -> if (x == 3 && y == 3) 255 else 1 }
        assertEquals(0, Display.of(lamp.floats(255f)).exposure)
    }

    @Test
    fun `a region about a place keeps within the picture`() {
        assertEquals(Region(88, 28, 24, 24), Region.around(Region(100, 40, 1, 1), 24, 480, 270))
        assertEquals(Region(0, 0, 24, 24), Region.around(Region(0, 0, 1, 1), 24, 480, 270))
        assertEquals(Region(456, 246, 24, 24), Region.around(Region(479, 269, 1, 1), 24, 480, 270))
        assertEquals(Region(0, 0, 5, 24), Region.around(Region(4, 30, 1, 1), 24, 5, 60).copy(y = 0))
        assertTrue(Region(456, 246, 16, 16) in Region(456, 246, 24, 24))
        val cut = Region(1, 1, 2, 1).cut(picture(3, 3) { x, y, _ -> 10 * y + x }.image)
        assertEquals(listOf(11, 12), cut.rgba.filterIndexed { i, _ -> i % 4 == 0 }.map { it.toInt() })
    }

    @Test
    fun `half a picture is the mean of its pixels, half an error map their largest`() {
        val image = picture(3, 2) { x, y, channel -> if (x == 1 && y == 0) 100 + channel else 0 }.image
        assertArrayEquals(byteArrayOf(25, 25, 26), Shrink.MEAN.halve(image).rgba.copyOfRange(0, 3))
        assertArrayEquals(byteArrayOf(100, 101, 102), Shrink.BRIGHTEST.halve(image).rgba.copyOfRange(0, 3))
        assertEquals(2 to 1, Shrink.MEAN.halve(image).let { it.width to it.height })
    }

    @Test
    fun `the difference is amplified as far as most of it allows`() {
        fun gain(
            change: Int,
        ) = gradient(48, 27).let { before -> PairView("id", "name", Comparison(before, before.plus(change)), Display.of(before)).gain }
        assertEquals(listOf(255, 64, 16, 4, 1), listOf(1, 3, 5, 50, 64).map(::gain))
    }

    private fun BytePicture.plus(change: Int) = picture(width, height) { x, y, channel ->
        (
            image.rgba[4 * (y * width + x) + channel].toInt() and
                0xFF
        ) +
            change
    }

    @Test
    fun `numbers are short and never wrong`() {
        assertEquals(listOf("0", "0.01234", "12.35", "1,234,567"), listOf(brief(0.0), brief(0.012344), brief(12.3456), grouped(1_234_567)))
        assertEquals(listOf("1.20e-05", "-3.5", "Infinity"), listOf(brief(1.2e-5), brief(-3.5), brief(Double.POSITIVE_INFINITY)))
        assertEquals(listOf("0 %", "< 0.01 %", "0.12 %", "> 99.99 %", "100 %"), listOf(0.0, 1e-9, 0.0012, 0.999999, 1.0).map(::percent))
        assertEquals("0.1  0.10000001", written(listOf(0.1f, Math.nextUp(0.1f))))
        assertEquals(listOf("2/255", "0.002"), listOf(step(2 / 255.0, gradient(1, 1)), step(0.002, gradient(1, 1).floats(1f))))
    }
}

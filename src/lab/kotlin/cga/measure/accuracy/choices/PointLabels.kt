package cga.measure.accuracy.choices

import org.knowm.xchart.internal.chartpart.Annotation
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.Rectangle
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.cos
import kotlin.math.sin

/**
 * The names of points, each beside its own, where it covers neither another name nor a point; XChart has no such thing. They are drawn as
 * outlines, as XChart draws its own texts, and so look the same where the font is missing.
 *
 * @param x the range of the axis; likewise [y].
 */
internal class PointLabels(
    private val points: List<Point>,
    private val x: ClosedRange<Double>,
    private val y: ClosedRange<Double>,
    private val font: Font,
    private val color: Color,
) : Annotation(false) {
    internal class Point(
        val x: Double,
        val y: Double,
        val text: String,
    )

    override fun paint(graphics: Graphics2D) {
        graphics.color = color
        val taken = points
            .map {
                Rectangle(getXAxisScreenValue(it.x), getYAxisScreenValue(it.y), 0, 0).apply { grow(MARKER, MARKER) }
            }.toMutableList()
        val axes = axes()
        for ((i, point) in points.withIndex()) {
            val text = Outline(graphics, font, point.text)
            val places = places(taken[i], text)
            val place = places.firstOrNull { place -> axes.contains(place) && taken.none(place::intersects) } ?: places.first()
            taken += place
            text.draw(place.x, place.y)
            drawLeader(graphics, taken[i], place)
        }
        drawSteps(graphics, axes)
    }

    private fun axes(): Rectangle {
        val left = getXAxisScreenValue(x.start)
        val top = getYAxisScreenValue(y.endInclusive)
        return Rectangle(left, top, getXAxisScreenValue(x.endInclusive) - left, getYAxisScreenValue(y.start) - top)
    }

    /** Beside the marker first, then round it, further and further away. */
    private fun places(
        marker: Rectangle,
        text: Outline,
    ): Sequence<Rectangle> =
        sequence {
            for (distance in 0..FARTHEST step STEP) {
                for (turn in TURNS) {
                    val angle = Math.toRadians(turn)
                    val x = marker.centerX + cos(angle) * (MARKER + GAP + distance + text.width / 2.0) - text.width / 2.0
                    val y = marker.centerY + sin(angle) * (MARKER + distance + text.height / 2.0) - text.height / 2.0
                    yield(Rectangle(x.toInt(), y.toInt(), text.width, text.height))
                }
            }
        }

    /** A line from the name to its point, where another could be meant. */
    private fun drawLeader(
        graphics: Graphics2D,
        marker: Rectangle,
        place: Rectangle,
    ) {
        if (Rectangle(place).apply { grow(3 * GAP, 2 * GAP) }.intersects(marker)) return
        val x = marker.centerX.toInt().coerceIn(place.x, place.x + place.width)
        val y = marker.centerY.toInt().coerceIn(place.y, place.y + place.height)
        graphics.drawLine(x, y, marker.centerX.toInt(), marker.centerY.toInt())
    }

    /** 2 and 5 between the powers of ten, which is all that XChart writes at a log axis. */
    private fun drawSteps(
        graphics: Graphics2D,
        axes: Rectangle,
    ) {
        for (number in generateSequence(1e-3) { 10 * it }.takeWhile { it < 1e6 }.flatMap { listOf(2 * it, 5 * it) }.filter { it in x }) {
            val text = Outline(graphics, font, tick(number))
            text.draw(getXAxisScreenValue(number) - text.width / 2, axes.y + axes.height + TICK)
        }
    }

    private class Outline(
        private val graphics: Graphics2D,
        font: Font,
        text: String,
    ) {
        private val metrics = graphics.getFontMetrics(font)
        private val glyphs = font.createGlyphVector(graphics.fontRenderContext, text)
        val width = metrics.stringWidth(text)
        val height = metrics.height

        /** From the upper left corner. */
        fun draw(
            x: Int,
            y: Int,
        ) {
            graphics.fill(glyphs.getOutline(x.toFloat(), (y + metrics.ascent).toFloat()))
        }
    }

    internal companion object {
        /** A number at an axis. */
        fun tick(x: Double): String =
            if (x in 1e-3..1e5) {
                BigDecimal.valueOf(x).round(MathContext(2)).stripTrailingZeros().toPlainString()
            } else {
                "%.0e".format(null, x).replace("e-0", "e-").replace("e+0", "e+")
            }

        /** Half a marker, the space beside it, and how far from it a name may go, in pixels. */
        private const val MARKER = 7
        private const val GAP = 3
        private const val STEP = 4
        private const val FARTHEST = 160

        /** From the axis down to its numbers, where XChart writes its own. */
        private const val TICK = 8

        /** Right, left, below, above, and between. */
        private val TURNS = listOf(0.0, 180.0, 90.0, -90.0, 45.0, -45.0, 135.0, -135.0)
    }
}

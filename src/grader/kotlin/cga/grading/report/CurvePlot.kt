package cga.grading.report

import cga.grading.findings.Plot
import cga.imaging.report.SvgElement
import cga.imaging.report.drawing
import kotlinx.html.FlowContent
import kotlinx.html.div
import kotlinx.html.figcaption
import kotlinx.html.figure
import kotlinx.html.p
import java.math.BigDecimal
import java.math.MathContext
import java.util.Locale
import kotlin.math.abs

/** Every measured curve over the one expected. */
internal fun FlowContent.curves(plots: List<Plot>, messages: Messages) {
    val drawable = plots.filter { it.x.size > 1 }
    if (drawable.isEmpty()) return
    part(messages.text("page.curves")) {
        p("note") { +messages.text("page.curves-about") }
        div("curves") { drawable.forEach { curve(it, messages) } }
    }
}

private fun FlowContent.curve(plot: Plot, messages: Messages) {
    val x = Axis.over(plot.x.toList(), LEFT, RIGHT)
    val y = Axis.over(plot.measured.toList() + plot.expected.toList(), BOTTOM, TOP)
    val (title, yours, expected) = listOf(plot.title, messages.text("page.yours"), messages.text("page.expected")).map { cleanLine(it) }
    figure("curve") {
        figcaption { +title }
        drawing("", WIDTH, HEIGHT, "$title: $yours, $expected") {
            for (tick in y.ticks) {
                element("path", "class" to "grid", "d" to "M$LEFT ${coordinate(y.at(tick))}H$RIGHT")
                element("text", "class" to "end", "x" to LEFT - GAP, "y" to y.at(tick) + LOWER) { +messages.tick(tick) }
            }
            for (tick in x.ticks) {
                element("path", "class" to "grid", "d" to "M${coordinate(x.at(tick))} ${TOP}V$BOTTOM")
                element("text", "class" to "middle", "x" to x.at(tick), "y" to BOTTOM + LINE) { +messages.tick(tick) }
            }
            element("path", "class" to "expected", "d" to path(plot.x, plot.expected, x, y))
            element("path", "class" to "measured", "d" to path(plot.x, plot.measured, x, y))
            element("text", "class" to "middle", "x" to (LEFT + RIGHT) / 2, "y" to HEIGHT - GAP) { +cleanLine(plot.xLabel, 2 * LABEL) }
            element("text", "x" to 0, "y" to TOP - LINE) { +cleanLine(plot.yLabel, LABEL) }
            legend(yours, expected)
        }
    }
}

/** Above the plot, where no curve runs. */
private fun SvgElement.legend(yours: String, expected: String) {
    val names = listOf("expected" to expected, "measured" to yours)
    for ((column, entry) in names.withIndex()) {
        val (style, name) = entry
        val right = RIGHT - column * COLUMN
        element("text", "class" to "end", "x" to right, "y" to TOP - LINE) { +name }
        element("path", "class" to style, "d" to "M${right - COLUMN + GAP} ${TOP - LINE - LOWER}h$KEY")
    }
}

/** A line through the points, or through as many of them as can be told apart. */
private fun path(xs: DoubleArray, ys: DoubleArray, x: Axis, y: Axis): String {
    val step = maxOf(1, xs.size / MOST_POINTS)
    val kept = xs.indices.sortedBy { xs[it] }.filterIndexed { i, _ -> i % step == 0 || i == xs.size - 1 }
    return kept.joinToString("") { (if (it == kept.first()) "M" else "L") + coordinate(x.at(xs[it])) + " " + coordinate(y.at(ys[it])) }
}

private fun coordinate(value: Double) = "%.1f".format(Locale.ROOT, value)

private fun Messages.tick(value: Double): String {
    val size = abs(value)
    if (size >= 1e5 || (size > 0 && size < 1e-3)) return "%.1e".format(Locale.ROOT, value)
    return number(BigDecimal(value).round(MathContext(4)).toDouble(), digits = 4)
}

private const val WIDTH = 440
private const val HEIGHT = 270
private const val LEFT = 48
private const val RIGHT = 430
private const val TOP = 30
private const val BOTTOM = 224
private const val LINE = 17
private const val LOWER = 4
private const val GAP = 6
private const val KEY = 26
private const val COLUMN = 100
private const val LABEL = 32
private const val MOST_POINTS = 400

package cga.imaging.report

import cga.imaging.brief
import cga.imaging.grouped
import kotlinx.html.FlowContent
import kotlinx.html.figcaption
import kotlinx.html.figure
import java.util.Locale
import kotlin.math.ceil
import kotlin.math.log10

/** One bar of a histogram: [count] things that fall under [label]. */
internal class Bar(
    val label: String,
    val count: Int,
)

/** A histogram whose counts are drawn to a logarithmic scale; [caption] says what is counted, [axis] what the labels are. */
internal fun FlowContent.histogram(caption: String, axis: String, bars: List<Bar>) {
    val decades = ceil(log10(maxOf(10, bars.maxOf { it.count }).toDouble())).toInt()
    val words = bars.filter { it.count > 0 }.joinToString { "${it.label}: ${it.count}" }
    figure("histogram") {
        figcaption { +caption }
        drawing("", WIDTH, HEIGHT, "$caption, by $axis: $words") {
            for (decade in 0..decades) {
                val y = BOTTOM - decade * (BOTTOM - TOP) / decades
                element("path", "class" to "grid", "d" to "M$LEFT ${y}H$WIDTH")
                element("text", "class" to "end", "x" to LEFT - GAP, "y" to y + LOWER) { +power(decade) }
            }
            bars.forEachIndexed { i, bar -> bar(bar, LEFT + i * (WIDTH - LEFT) / bars.size, (WIDTH - LEFT) / bars.size, decades) }
            element("text", "class" to "middle", "x" to (LEFT + WIDTH) / 2, "y" to HEIGHT - GAP) { +axis }
        }
    }
}

private fun SvgElement.bar(bar: Bar, x: Int, width: Int, decades: Int) {
    val middle = x + width / 2
    element("text", "class" to "middle", "x" to middle, "y" to BOTTOM + LINE) { +bar.label }
    if (bar.count == 0) return
    // One thing is no bar of height 0: the scale begins a little below 1.
    val height = LEAST + (log10(bar.count.toDouble()) / decades * (BOTTOM - TOP)).toInt()
    element("rect", "class" to "bar", "x" to x + GAP / 2, "y" to BOTTOM - height, "width" to width - GAP, "height" to height) {
        element("title") { +"${bar.label}: ${grouped(bar.count)}" }
    }
    element("text", "class" to "middle", "x" to middle, "y" to BOTTOM - height - GAP) { +brief(bar.count) }
}

private fun power(decade: Int) = brief(generateSequence(1) { it * 10 }.elementAt(decade))

/** Three digits at most, as 129k. */
private fun brief(count: Int): String =
    when {
        count < 1000 -> "$count"
        count < 10_000 && count % 1000 != 0 -> "%.1fk".format(Locale.ROOT, count / 1e3)
        count < 1_000_000 -> "${count / 1000}k"
        else -> "${count / 1_000_000}M"
    }

private const val WIDTH = 420
private const val HEIGHT = 160
private const val LEFT = 40
private const val TOP = 18
private const val BOTTOM = 122
private const val LINE = 15
private const val LOWER = 4
private const val GAP = 6
private const val LEAST = 2

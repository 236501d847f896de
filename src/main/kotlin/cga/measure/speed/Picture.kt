package cga.measure.speed

import cga.framework.AtomicFile
import cga.measure.ChartStyle
import org.knowm.xchart.ChartEncoder
import org.knowm.xchart.XYChartBuilder
import java.nio.file.Path
import kotlin.io.path.outputStream
import kotlin.io.path.writeText

/** A picture of the report, which is written as [name].svg. */
internal interface Picture {
    val name: String
    val title: String

    fun write(folder: Path)
}

/** Lines over two logarithmic axes: by series the points (x, y), all positive. */
internal class LinePicture(
    override val name: String,
    override val title: String,
    private val xTitle: String,
    private val yTitle: String,
    private val series: Map<String, List<Pair<Double, Double>>>,
) : Picture {
    override fun write(folder: Path) {
        val chart = XYChartBuilder().width(900).height(480).title(title).xAxisTitle(xTitle).yAxisTitle(yTitle).build()
        ChartStyle.apply(chart)
        val points = series.values.flatten()
        val (xs, ys) = listOf(points.map { it.first }, points.map { it.second })
        chart.styler.setXAxisMin(xs.min() / MARGIN).setXAxisMax(xs.max() * MARGIN)
        chart.styler.setYAxisMin(ys.min() / MARGIN).setYAxisMax(ys.max() * MARGIN)
        series.entries.forEachIndexed { i, (name, points) ->
            val line = chart.addSeries(name, points.map { it.first }.toDoubleArray(), points.map { it.second }.toDoubleArray())
            line.setMarker(ChartStyle.marker(i)).setMarkerColor(ChartStyle.color(i)).setLineColor(ChartStyle.color(i)).setLineWidth(2f)
        }
        AtomicFile.write(folder.resolve("$name.svg")) { file -> file.outputStream().use { ChartEncoder.saveChart(chart, it, "svg") } }
    }

    private companion object {
        /** Room about the points, as a factor. */
        const val MARGIN = 1.5
    }
}

/** When what ran: a bar for each of [spans] (name to start and end in milliseconds), one below the other. */
internal class TimelinePicture(
    override val name: String,
    override val title: String,
    private val spans: List<Pair<String, ClosedRange<Double>>>,
) : Picture {
    override fun write(folder: Path): Unit = AtomicFile.write(folder.resolve("$name.svg")) { it.writeText(svg()) }

    private fun svg(): String {
        val end = spans.maxOf { it.second.endInclusive }
        val scale = (WIDTH - LEFT - RIGHT) / end
        val bars = spans.mapIndexed { i, (name, span) -> bar(i, name, LEFT + span.start * scale, LEFT + span.endInclusive * scale, span) }
        val height = TOP + ROW * spans.size + 10
        return """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 $WIDTH $height" font-family="sans-serif" font-size="13" fill="#222222">
<rect width="$WIDTH" height="$height" fill="#ffffff"/>
<text x="${WIDTH / 2}" y="22" font-size="16" font-weight="bold" text-anchor="middle">$title</text>
${bars.joinToString("\n")}
</svg>
"""
    }

    private fun bar(
        row: Int,
        name: String,
        left: Double,
        right: Double,
        span: ClosedRange<Double>,
    ): String {
        val top = TOP + ROW * row
        val text = "%.0f ms".format(null, span.endInclusive - span.start)
        return """<text x="${LEFT - 8}" y="${top + 15}" text-anchor="end">$name</text>
<rect x="${"%.1f".format(
            null,
            left,
        )}" y="$top" width="${"%.1f".format(null, maxOf(right - left, 1.0))}" height="${ROW - 4}" fill="#0072b2"/>
<text x="${"%.1f".format(null, right + 5)}" y="${top + 15}">$text</text>"""
    }

    private companion object {
        const val WIDTH = 900
        const val LEFT = 190
        const val RIGHT = 70
        const val TOP = 40
        const val ROW = 24
    }
}

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

/** When what ran: a row for each name of [spans] with a bar for each time it ran (start and end in milliseconds), and the sum of them. */
internal class TimelinePicture(
    override val name: String,
    override val title: String,
    private val spans: List<Pair<String, ClosedRange<Double>>>,
) : Picture {
    override fun write(folder: Path): Unit = AtomicFile.write(folder.resolve("$name.svg")) { it.writeText(svg()) }

    private fun svg(): String {
        val scale = (WIDTH - LEFT - RIGHT) / spans.maxOf { it.second.endInclusive }
        val rows = spans.groupBy({ it.first }, { it.second }).entries.mapIndexed { i, (name, ran) -> row(TOP + ROW * i, name, ran, scale) }
        val height = TOP + ROW * rows.size + 10
        return """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 $WIDTH $height" font-family="sans-serif" font-size="13" fill="#222222">
<rect width="$WIDTH" height="$height" fill="#ffffff"/>
<text x="${WIDTH / 2}" y="22" font-size="16" font-weight="bold" text-anchor="middle">$title</text>
${rows.joinToString("\n")}
</svg>
"""
    }

    private fun row(
        top: Int,
        name: String,
        ran: List<ClosedRange<Double>>,
        scale: Double,
    ): String {
        val bars =
            ran.map {
                val width = maxOf((it.endInclusive - it.start) * scale, 1.0)
                """<rect x="${digits(LEFT + it.start * scale)}" y="$top" width="${digits(width)}" height="${ROW - 4}" fill="#0072b2"/>"""
            }
        val sum = "%.0f ms".format(null, ran.sumOf { it.endInclusive - it.start })
        val end = digits(LEFT + ran.maxOf { it.endInclusive } * scale + 5)
        return """<text x="${LEFT - 8}" y="${top + 15}" text-anchor="end">$name</text>
${bars.joinToString("\n")}
<text x="$end" y="${top + 15}">$sum</text>"""
    }

    private fun digits(x: Double) = "%.1f".format(null, x)

    private companion object {
        const val WIDTH = 900
        const val LEFT = 190
        const val RIGHT = 70
        const val TOP = 40
        const val ROW = 24
    }
}

package cga.measure.accuracy.choices

import cga.framework.AtomicFile
import cga.measure.ChartStyle
import org.knowm.xchart.ChartEncoder
import org.knowm.xchart.XYChart
import org.knowm.xchart.XYChartBuilder
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle
import org.knowm.xchart.style.lines.SeriesLines
import org.knowm.xchart.style.markers.SeriesMarkers
import java.awt.Color
import java.awt.Font
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.outputStream

/**
 * Cost against error, both on log axes, with the front of the best drawn as a line. The truth itself, with no error, is left out.
 *
 * @param name of its files.
 * @param series groups of points, each in a colour of its own.
 * @param error which of the errors is plotted.
 */
public class ParetoPlot(
    public val name: String,
    public val title: String,
    private val costTitle: String,
    private val errorTitle: String,
    series: Map<String, List<Measured>>,
    private val error: (Measured) -> Double,
) {
    private val series = series.mapValues { (_, rows) -> rows.filter { error(it) > 0 } }.filterValues { it.isNotEmpty() }
    private val points = this.series.values.flatten()

    /** The ranges of the axes, with room for names. */
    private val costs = points.minOf { it.cost.median } / 1.3..points.maxOf { it.cost.median } * 1.6
    private val errors = points.minOf(error) / 3..points.maxOf(error) * 3

    /** Writes NAME.svg and NAME.png into [folder]. */
    public fun write(folder: Path) {
        AtomicFile.write(folder.resolve("$name.svg")) { file ->
            file.outputStream().use { ChartEncoder.saveChart(chart(), it, "svg") }
        }
        AtomicFile.write(folder.resolve("$name.png")) { ImageIO.write(bitmap(), "png", it.toFile()) }
    }

    /** Twice as fine as the page shows it. */
    private fun bitmap(): BufferedImage {
        val image = BufferedImage(2 * WIDTH, 2 * HEIGHT, BufferedImage.TYPE_INT_RGB)
        val graphics = image.createGraphics()
        graphics.scale(2.0, 2.0)
        chart().paint(graphics, WIDTH, HEIGHT)
        graphics.dispose()
        return image
    }

    private fun chart(): XYChart {
        val chart = XYChartBuilder().width(WIDTH).height(HEIGHT).title(title).xAxisTitle(costTitle).yAxisTitle(errorTitle).build()
        style(chart)
        addFront(chart)
        for ((i, entry) in series.entries.withIndex()) {
            val (name, rows) = entry
            val points = chart.addSeries(name, rows.map { it.cost.median }.toDoubleArray(), rows.map(error).toDoubleArray())
            points.setXYSeriesRenderStyle(XYSeriesRenderStyle.Scatter)
            points.setMarker(ChartStyle.marker(i)).setMarkerColor(ChartStyle.color(i))
        }
        val labels = points.map { PointLabels.Point(it.cost.median, error(it), it.name) }
        chart.addAnnotation(PointLabels(labels, costs, errors, ChartStyle.font(Font.PLAIN, 12), ChartStyle.TEXT))
        return chart
    }

    private fun addFront(chart: XYChart) {
        val front = Pareto.front(points, error)
        val line = chart.addSeries(
            "front: nothing is faster and nearer",
            front
                .map {
                    it.cost.median
                }.toDoubleArray(),
            front.map(error).toDoubleArray(),
        )
        line.setXYSeriesRenderStyle(XYSeriesRenderStyle.Line)
        line.setMarker(SeriesMarkers.NONE).setLineStyle(SeriesLines.SOLID).setLineColor(FRONT)
        line.setLineWidth(3f)
    }

    private fun style(chart: XYChart) {
        ChartStyle.apply(chart)
        val styler = chart.styler
        styler.setXAxisMin(costs.start).setXAxisMax(costs.endInclusive)
        styler.setYAxisMin(errors.start).setYAxisMax(errors.endInclusive)
        styler.setXAxisTickLabelsFormattingFunction(PointLabels::tick)
        styler.setYAxisTickLabelsFormattingFunction(PointLabels::tick)
    }

    private companion object {
        const val WIDTH = 900
        const val HEIGHT = 560
        val FRONT = Color(0xB8, 0xC4, 0xD8)
    }
}

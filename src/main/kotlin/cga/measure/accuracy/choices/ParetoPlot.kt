package cga.measure.accuracy.choices

import cga.framework.AtomicFile
import org.knowm.xchart.ChartEncoder
import org.knowm.xchart.XYChart
import org.knowm.xchart.XYChartBuilder
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle
import org.knowm.xchart.style.Styler.LegendLayout
import org.knowm.xchart.style.Styler.LegendPosition
import org.knowm.xchart.style.lines.SeriesLines
import org.knowm.xchart.style.markers.SeriesMarkers
import java.awt.BasicStroke
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
            points.setMarker(MARKERS[i % MARKERS.size]).setMarkerColor(COLORS[i % COLORS.size])
        }
        val labels = points.map { PointLabels.Point(it.cost.median, error(it), it.name) }
        chart.addAnnotation(PointLabels(labels, costs, errors, font(Font.PLAIN, 12), TEXT))
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
        val styler = chart.styler
        styler.setXAxisLogarithmic(true).setYAxisLogarithmic(true)
        styler.setXAxisMin(costs.start).setXAxisMax(costs.endInclusive)
        styler.setYAxisMin(errors.start).setYAxisMax(errors.endInclusive)
        styler.setXAxisTickLabelsFormattingFunction(PointLabels::tick)
        styler.setYAxisTickLabelsFormattingFunction(PointLabels::tick)
        styler.setAxisTickLabelsFont(font(Font.PLAIN, 13)).setAxisTitleFont(font(Font.PLAIN, 14)).setPlotMargin(0)
        styler.setPlotContentSize(1.0)
        styler.setPlotGridLinesColor(GRID).setPlotGridLinesStroke(BasicStroke(1f))
        styler.setChartTitleFont(font(Font.BOLD, 16)).setChartTitleBoxVisible(false).setChartBackgroundColor(Color.WHITE)
        styler.setChartFontColor(TEXT).setPlotBackgroundColor(Color.WHITE).setPlotBorderColor(GRID)
        styler.setLegendPosition(LegendPosition.OutsideS).setLegendLayout(LegendLayout.Horizontal).setLegendFont(font(Font.PLAIN, 13))
        styler.setLegendBorderColor(Color.WHITE).setMarkerSize(11).setAntiAlias(true).setTextAntiAlias(true)
    }

    private companion object {
        const val WIDTH = 900
        const val HEIGHT = 560
        val TEXT = Color(0x22, 0x22, 0x22)
        val GRID = Color(0xDD, 0xDD, 0xDD)
        val FRONT = Color(0xB8, 0xC4, 0xD8)

        // Told apart by those who see few colours as well (Okabe and Ito 2008), and by their shapes.
        val COLORS = listOf(Color(0x00, 0x72, 0xB2), Color(0xD5, 0x5E, 0x00), Color(0x00, 0x9E, 0x73), Color(0xCC, 0x79, 0xA7))
        val MARKERS = listOf(SeriesMarkers.CIRCLE, SeriesMarkers.SQUARE, SeriesMarkers.DIAMOND, SeriesMarkers.TRIANGLE_UP)

        fun font(
            style: Int,
            size: Int,
        ) = Font(Font.SANS_SERIF, style, size)
    }
}

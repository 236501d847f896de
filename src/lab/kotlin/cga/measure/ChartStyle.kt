package cga.measure

import org.knowm.xchart.XYChart
import org.knowm.xchart.style.Styler.LegendLayout
import org.knowm.xchart.style.Styler.LegendPosition
import org.knowm.xchart.style.markers.Marker
import org.knowm.xchart.style.markers.SeriesMarkers
import java.awt.BasicStroke
import java.awt.Color
import java.awt.Font

/** How the plots of our documents look: two logarithmic axes, white, the legend below. */
internal object ChartStyle {
    val TEXT: Color = Color(0x22, 0x22, 0x22)
    private val GRID = Color(0xDD, 0xDD, 0xDD)

    // Told apart by those who see few colours as well (Okabe and Ito 2008), and by their shapes.
    private val COLORS = listOf(Color(0x00, 0x72, 0xB2), Color(0xD5, 0x5E, 0x00), Color(0x00, 0x9E, 0x73), Color(0xCC, 0x79, 0xA7))
    private val MARKERS = listOf(SeriesMarkers.CIRCLE, SeriesMarkers.SQUARE, SeriesMarkers.DIAMOND, SeriesMarkers.TRIANGLE_UP)

    /** Of the series [number]. */
    fun color(number: Int): Color = COLORS[number % COLORS.size]

    /** Of the series [number]. */
    fun marker(number: Int): Marker = MARKERS[number % MARKERS.size]

    fun font(
        style: Int,
        size: Int,
    ): Font = Font(Font.SANS_SERIF, style, size)

    fun apply(chart: XYChart) {
        val styler = chart.styler
        styler.setXAxisLogarithmic(true).setYAxisLogarithmic(true)
        styler.setAxisTickLabelsFont(font(Font.PLAIN, 13)).setAxisTitleFont(font(Font.PLAIN, 14)).setPlotMargin(0)
        styler.setPlotContentSize(1.0)
        styler.setPlotGridLinesColor(GRID).setPlotGridLinesStroke(BasicStroke(1f))
        styler.setChartTitleFont(font(Font.BOLD, 16)).setChartTitleBoxVisible(false).setChartBackgroundColor(Color.WHITE)
        styler.setChartFontColor(TEXT).setPlotBackgroundColor(Color.WHITE).setPlotBorderColor(GRID)
        styler.setLegendPosition(LegendPosition.OutsideS).setLegendLayout(LegendLayout.Horizontal).setLegendFont(font(Font.PLAIN, 13))
        styler.setLegendBorderColor(Color.WHITE).setMarkerSize(11).setAntiAlias(true).setTextAntiAlias(true)
    }
}

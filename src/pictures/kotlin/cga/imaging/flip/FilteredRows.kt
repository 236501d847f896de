package cga.imaging.flip

/** Filters one picture, row by row from top to bottom. Rows may be left out: they then cost nothing. */
internal class FilteredRows(
    private val source: LinearRows,
    private val spatial: SpatialFilter,
    private val feature: FeatureFilter,
) {
    private val width = source.width
    private val radius = maxOf(spatial.radius, feature.radius)
    private val raw = ColorRow(width)
    private val padded = FloatArray(width + 2 * radius)
    private var nextRow = 0

    // Filtered along the rows; the second direction follows when a row is asked for.
    private val luminance = window()
    private val redGreen = window()
    private val blueYellow = spatial.blueYellow.map { window() }
    private val blurred = window()
    private val sloped = window()
    private val curved = window()

    /** What the eye sees of the row that [moveTo] went to, in CIELab with Hunt's scaling. */
    val color: ColorRow = ColorRow(width)

    /** How much of an edge each pixel of that row is. */
    val edge: Gradient = Gradient(width)

    /** How much of a point each pixel of that row is. */
    val point: Gradient = Gradient(width)

    /** Computes [color], [edge] and [point] of row [y], which must lie below all rows before. */
    fun moveTo(y: Int) {
        for (row in maxOf(nextRow, y - radius)..minOf(y + radius, source.height - 1)) filterAlong(row)
        nextRow = minOf(y + radius, source.height - 1) + 1
        seeColors(y)
        edge.set(sloped, blurred, y, feature.blur, feature.slope)
        point.set(curved, blurred, y, feature.blur, feature.curvature)
    }

    private fun filterAlong(y: Int) {
        source.read(y, raw)
        ColorSpace.linearToOpponent(raw)
        pad(raw.first)
        spatial.luminance.alongRow(padded, radius, luminance[y])
        feature.blur.alongRow(padded, radius, blurred[y])
        feature.slope.alongRow(padded, radius, sloped[y])
        feature.curvature.alongRow(padded, radius, curved[y])
        pad(raw.second)
        spatial.redGreen.alongRow(padded, radius, redGreen[y])
        pad(raw.third)
        for ((taps, rows) in spatial.blueYellow zip blueYellow) taps.alongRow(padded, radius, rows[y])
    }

    /** Beyond the picture its outermost pixels go on. */
    private fun pad(row: FloatArray) {
        padded.fill(row[0], 0, radius)
        row.copyInto(padded, radius)
        padded.fill(row[width - 1], radius + width, padded.size)
    }

    private fun seeColors(y: Int) {
        color.first.fill(0f)
        color.second.fill(0f)
        color.third.fill(0f)
        spatial.luminance.acrossRows(luminance, y, color.first)
        spatial.redGreen.acrossRows(redGreen, y, color.second)
        for ((taps, rows) in spatial.blueYellow zip blueYellow) taps.acrossRows(rows, y, color.third)
        ColorSpace.opponentToHuntLab(color)
    }

    private fun window() = RowWindow(width, source.height, radius)
}

/** A derivative of a row of the luminance in both directions. */
internal class Gradient(width: Int) {
    private val alongX = FloatArray(width)
    private val alongY = FloatArray(width)

    /** Filters [derived] with [blur] and [blurred] with the [derivative], across the rows about row [y]. */
    fun set(
        derived: RowWindow,
        blurred: RowWindow,
        y: Int,
        blur: Taps,
        derivative: Taps,
    ) {
        alongX.fill(0f)
        alongY.fill(0f)
        blur.acrossRows(derived, y, alongX)
        derivative.acrossRows(blurred, y, alongY)
    }

    /** Its length at pixel [x]. */
    fun length(x: Int): Float = kotlin.math.sqrt(alongX[x] * alongX[x] + alongY[x] * alongY[x])
}

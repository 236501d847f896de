package cga.imaging.flip

import java.util.stream.IntStream
import kotlin.math.max

/** Two pictures of the same size to compare with LDR-ꟻLIP. */
internal class LinearPair(
    val expected: LinearRows,
    val actual: LinearRows,
)

/**
 * The LDR-ꟻLIP of [pairs] of pictures, of every pixel the largest.
 *
 * @param differs of every row, from the top, whether the pictures of any pair differ in it.
 */
internal class LargestError(
    private val pairs: List<LinearPair>,
    private val differs: BooleanArray,
    pixelsPerDegree: Double,
) {
    private val width = pairs[0].expected.width
    private val height = differs.size
    private val spatial = SpatialFilter(pixelsPerDegree)
    private val feature = FeatureFilter(pixelsPerDegree)
    private val radius = max(spatial.radius, feature.radius)
    private val errors = FloatArray(width * height)

    /** The errors of all pixels, computed by as many threads as there are processors. */
    fun map(): FloatArray {
        val bands = (height / (BAND * radius)).coerceIn(1, 2 * Runtime.getRuntime().availableProcessors())
        IntStream.range(0, bands).parallel().forEach { band ->
            val rows = (height * band / bands until height * (band + 1) / bands).filter(::isNearDifference)
            if (rows.isNotEmpty()) pairs.forEach { compare(it, rows) }
        }
        return errors
    }

    /** Whether row [y] can have an error: where all that the filters reach is equal, so are their sums, to the last bit. */
    private fun isNearDifference(y: Int): Boolean = (max(0, y - radius)..minOf(height - 1, y + radius)).any { differs[it] }

    private fun compare(
        pair: LinearPair,
        rows: List<Int>,
    ) {
        val expected = FilteredRows(pair.expected, spatial, feature)
        val actual = FilteredRows(pair.actual, spatial, feature)
        for (y in rows) {
            expected.moveTo(y)
            actual.moveTo(y)
            for (x in 0 until width) {
                val at = y * width + x
                errors[at] = max(errors[at], PixelError.of(expected, actual, x))
            }
        }
    }

    private companion object {
        /** Least height of a band of rows in radii: a band repeats a radius of its neighbours' work above and below. */
        const val BAND = 4
    }
}

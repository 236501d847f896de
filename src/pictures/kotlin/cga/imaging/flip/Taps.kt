package cga.imaging.flip

/**
 * A filter of odd length: [weights] holds that of its centre and those to the right of it. The left half mirrors the right one, with
 * the opposite sign if the filter is [odd].
 */
internal class Taps(
    private val weights: FloatArray,
    private val odd: Boolean = false,
) {
    private val radius = weights.size - 1

    /** Filters a row: [padded] holds it between two margins of [margin] numbers each, [result] becomes the sum. */
    fun alongRow(
        padded: FloatArray,
        margin: Int,
        result: FloatArray,
    ) {
        val center = weights[0]
        for (i in result.indices) result[i] = center * padded[margin + i]
        for (k in 1..radius) addPair(padded, margin - k, padded, margin + k, weights[k], result)
    }

    /** Filters [rows] about row [y], from top to bottom, and adds the sum to [result]. */
    fun acrossRows(
        rows: RowWindow,
        y: Int,
        result: FloatArray,
    ) {
        addPair(rows[y], 0, rows[y], 0, weights[0] / 2, result)
        for (k in 1..radius) addPair(rows[y - k], 0, rows[y + k], 0, weights[k], result)
    }

    // The innermost loops of all: plain enough for the JIT compiler to vectorize.
    private fun addPair(
        left: FloatArray,
        leftAt: Int,
        right: FloatArray,
        rightAt: Int,
        weight: Float,
        result: FloatArray,
    ) {
        if (odd) {
            for (i in result.indices) result[i] += weight * (right[rightAt + i] - left[leftAt + i])
        } else {
            for (i in result.indices) result[i] += weight * (right[rightAt + i] + left[leftAt + i])
        }
    }
}

package cga.inspect.soak

import kotlin.math.sqrt

/**
 * How fast something grows, by Theil and Sen: the median of the slopes between all pairs of points. Up to 29 % of the points may be
 * anywhere.
 *
 * @param slope per unit of x.
 * @param low the slope is at least this, with a confidence of 99.5 %: from how many of the pairs may rise by chance alone (Kendall's S,
 *   whose variance is n(n−1)(2n+5)/18).
 * @param high likewise at most this.
 */
internal class Trend private constructor(
    val slope: Double,
    val low: Double,
    val high: Double,
) {
    companion object {
        /** The standard normal distribution's 99.5th percentile. */
        private const val Z = 2.576

        /** The trend of [y] over [x], which rises; two points at least. */
        fun of(
            x: DoubleArray,
            y: DoubleArray,
        ): Trend {
            val n = x.size
            require(n >= 2 && y.size == n) { "$n points and ${y.size} values: two at least, and as many of both" }
            val slopes = (0 until n).flatMap { i -> (i + 1 until n).map { j -> (y[j] - y[i]) / (x[j] - x[i]) } }.sorted()
            val chance = Z * sqrt(n * (n - 1) * (2 * n + 5) / 18.0)
            val low = ((slopes.size - chance) / 2).toInt().coerceAtLeast(0)
            return Trend(slopes[slopes.size / 2], slopes[low], slopes[slopes.lastIndex - low])
        }
    }
}

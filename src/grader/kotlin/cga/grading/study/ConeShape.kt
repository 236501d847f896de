package cga.grading.study

import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.cos
import kotlin.math.sqrt

/**
 * What the strength of a light does with the angle θ to its axis.
 *
 * @param full the strength that counts as 1.
 * @param error what the formula of the sheet with these edges leaves, relative to [full]; [residual] what a formula of this [falloff] leaves.
 */
internal class ConeShape(
    val cosInner: Double,
    val cosOuter: Double,
    val full: Double,
    val falloff: Falloff,
    val error: Double,
    val residual: Double = error,
) {
    companion object {
        /** Describes [profile] over [thetas] (0 to π); [measure] looks closer where an edge is too sharp for them. */
        @Suppress("UNUSED_PARAMETER")
        fun of(
            axis: Vector3dc,
            profile: DoubleArray,
            thetas: DoubleArray,
            measure: (DoubleArray) -> DoubleArray,
        ): ConeShape {
            val high = profile.max()
            val low = profile.min()
            val margin = 1e-4 * (high - low)
            var angles = thetas
            var values = profile
            var partial = values.indices.filter { values[it] > low + margin && values[it] < high - margin }
            if (partial.size < ENOUGH) {
                // The whole edge lies between two angles: look closer there, as often as need be.
                val edge = edge(thetas, profile, (high + low) / 2) ?: return ConeShape(-1.0, -1.0, high, Falloff.OTHER, 1.0)
                var (near, far) = edge
                repeat(ZOOMS) {
                    angles = DoubleArray(33) { near + (far - near) * it / 32 }
                    values = measure(angles)
                    partial = values.indices.filter { values[it] > low + margin && values[it] < high - margin }
                    if (partial.size >= ENOUGH) return@repeat
                    edge(angles, values, (high + low) / 2)?.let { (a, b) ->
                        near = a
                        far = b
                    }
                }
                if (partial.size < ENOUGH) {
                    val cosine = cos((near + far) / 2)
                    return ConeShape(cosine, cosine, high, Falloff.HARD, 0.0)
                }
            }
            return sloped(angles, values, partial, low, high, profile, thetas)
        }

        private fun sloped(
            angles: DoubleArray,
            values: DoubleArray,
            partial: List<Int>,
            low: Double,
            high: Double,
            profile: DoubleArray,
            thetas: DoubleArray,
        ): ConeShape {
            val cosines = partial.map { cos(angles[it]) }
            val (slope, offset) = line(cosines, partial.map { values[it] }) ?: return ConeShape(-1.0, -1.0, high, Falloff.OTHER, 1.0)
            // Cosines of narrow cones are floats near 1: two of them, half a unit in the last place each, over their difference.
            val rounding = ROUNDING * abs(slope) / (high - low)
            val misfit = partial.indices.maxOf { abs(slope * cosines[it] + offset - values[partial[it]]) } / (high - low)
            val dark = if (low < -1e-3 * high) 0.0 else low
            if (misfit < STRAIGHT + rounding) {
                val atAxis = slope + offset
                val plateau = profile[0] < atAxis - 1e-3 * (high - low)
                val floor = low >= -1e-3 * high
                val falloff = if (!floor) {
                    Falloff.UNCLAMPED
                } else if (plateau) {
                    Falloff.LINEAR
                } else {
                    Falloff.UNCLAMPED_ABOVE
                }
                val outer = (dark - offset) / slope
                val inner = if (plateau) (high - offset) / slope else 1.0
                val error =
                    thetas.indices.maxOf { i -> abs((slope * cos(thetas[i]) + offset).coerceIn(minOf(dark, low), high) - profile[i]) } /
                        (high - low)
                return ConeShape(inner, outer, high, falloff, error)
            }
            val smooth = partial.map { unsmooth(((values[it] - low) / (high - low)).coerceIn(0.0, 1.0)) }
            val fit = line(cosines, smooth)
            if (fit != null && partial.indices.all { abs(fit.first * cosines[it] + fit.second - smooth[it]) < SMOOTH }) {
                val shares = partial.map { (values[it] - low) / (high - low) }
                val error = cosines.indices.maxOf { abs(fit.first * cosines[it] + fit.second - shares[it]) }
                return ConeShape((1 - fit.second) / fit.first, -fit.second / fit.first, high, Falloff.SMOOTH, error, residual = 0.0)
            }
            return bent(partial.map { angles[it] }, partial.map { values[it] }, low, high, misfit)
                ?: ConePower.of(cosines, partial.map { values[it] }, low, high)
                ?: ConeShape((high - offset) / slope, (dark - offset) / slope, high, Falloff.OTHER, misfit)
        }

        /** A straight line over something else than the cosine; [misfit] is what that leaves. */
        private fun bent(
            angles: List<Double>,
            values: List<Double>,
            low: Double,
            high: Double,
            misfit: Double,
        ): ConeShape? {
            fun straight(
                falloff: Falloff,
                abscissa: (Double) -> Double,
                cosine: (Double) -> Double,
            ): ConeShape? {
                val x = angles.map(abscissa)
                val (slope, offset) = line(x, values) ?: return null
                if (x.indices.any { abs(slope * x[it] + offset - values[it]) > STRAIGHT * (high - low) }) return null
                val error = if (falloff == Falloff.COSINE_TWICE) 0.0 else misfit
                return ConeShape(cosine((high - offset) / slope), cosine((low - offset) / slope), high, falloff, error, residual = 0.0)
            }
            return straight(Falloff.IN_ANGLE, { it }, ::cos) ?: straight(Falloff.COSINE_TWICE, { cos(cos(it)) }, ::acos)
        }

        /** The first two neighbouring angles between which the values cross [level]. */
        private fun edge(
            angles: DoubleArray,
            values: DoubleArray,
            level: Double,
        ): Pair<Double, Double>? {
            val at = (1 until angles.size).firstOrNull { (values[it - 1] - level) * (values[it] - level) <= 0 } ?: return null
            return angles[at - 1] to angles[at]
        }

        /** Slope and offset of the line through [y] over [x]; null where all x are one. */
        fun line(
            x: List<Double>,
            y: List<Double>,
        ): Pair<Double, Double>? {
            // About the mean, where nothing cancels in narrow cones.
            val middle = x.average()
            val spread = sqrt(x.sumOf { (it - middle) * (it - middle) } / x.size)
            if (!(spread > 0)) return null
            val equations = LeastSquares(2)
            for (i in x.indices) equations.add(doubleArrayOf((x[i] - middle) / spread, 1.0), y[i])
            val (slope, offset) = equations.solve()?.let { it[0] / spread to it[1] } ?: return null
            return slope to offset - slope * middle
        }

        /** The t of which [s] is the smoothstep 3t² − 2t³. */
        private fun unsmooth(s: Double): Double = 0.5 - kotlin.math.sin(kotlin.math.asin(1 - 2 * s) / 3)

        private const val ENOUGH = 6
        private const val ZOOMS = 8

        /** What a straight line may leave, relative to the range of what it describes. */
        const val STRAIGHT: Double = 2e-3
        private const val ROUNDING = 2.4e-7
        private const val SMOOTH = 1e-2
    }
}

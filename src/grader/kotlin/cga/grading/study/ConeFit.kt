package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.acos

/** How a cone falls off between its two edges. */
internal enum class Falloff {
    LINEAR,
    UNCLAMPED_ABOVE,
    UNCLAMPED,
    HARD,
    SMOOTH,

    /** Linear in the angle itself. */
    IN_ANGLE,

    /** Linear in the cosine of the angle's cosine. */
    COSINE_TWICE,

    /** A power of what is linear in the cosine: multiplied by itself, or the exponent of an older kind of spotlight. */
    POWER,
    OTHER,
}

/**
 * The cone of a light as it is drawn.
 *
 * @param axis away from the light, in the placement's space, unit length; the cone is lit around it.
 * @param cosInner cosine of the angle up to which it shines fully, [cosOuter] of that from which it is dark.
 * @param error what the formula of the sheet with these edges leaves, relative to full light.
 * @param residual what is left where the shape of its [falloff] is allowed for.
 * @param thetas angles of the measured profile, [intensities] relative to full light.
 */
internal class ConeFit(
    val axis: Vector3dc,
    val cosInner: Double,
    val cosOuter: Double,
    val falloff: Falloff,
    val error: Double,
    val thetas: DoubleArray,
    val intensities: DoubleArray,
    val residual: Double = error,
) {
    val inner: Double get() = acos(cosInner.coerceIn(-1.0, 1.0))
    val outer: Double get() = acos(cosOuter.coerceIn(-1.0, 1.0))

    private val isLitAtAxis: Boolean get() = intensities[0] > 0.5

    /**
     * A direction in which it shines fully: beside its axis, unless it is dark there. On the axis itself a rounded cosine may be larger
     * than 1, and its angle no number.
     */
    val brightest: Vector3dc
        get() {
            val theta = if (isLitAtAxis) minOf(inner / 4, BESIDE) else thetas[intensities.indices.maxBy { intensities[it] }]
            return Directions.around(axis, theta, 0.7)
        }

    /** I where the cosine to the axis is [cosine]. */
    fun intensity(cosine: Double): Double = ((cosine - cosOuter) / (cosInner - cosOuter)).coerceIn(0.0, 1.0)

    companion object {
        /** The cone of the light that [amplitudes] measures, null where it shines evenly; [lit] are points that it shines on, [hints] likely axes. */
        fun of(
            amplitudes: Amplitudes,
            lit: List<Vector3dc>,
            hints: List<Vector3dc>,
        ): ConeFit? {
            val around = Directions.sphere(COARSE)
            val coarse = amplitudes.along(around, DISTANCE)
            val top = coarse.largest()
            if (coarse.all { it.isFinite() } && coarse.max() - coarse.min() < EVEN * top) return null
            val towardsLit = lit.map { Vector3d(amplitudes.placement.toLight(it)).negate().normalize() }
            val search = ConeSearch(amplitudes, DISTANCE)
            var best: ConeFit? = null
            for (start in listOfNotNull(centroid(around, coarse), mean(towardsLit)) + hints) {
                val fit = search.refine(start) ?: continue
                if (fit.residual < GOOD && fit.isLitAtAxis) return fit
                if (best == null || fit.residual < best.residual) best = fit
            }
            // What is the same on both sides of the axis leads no search to it.
            val all = hints.mapNotNull(search::about) + listOfNotNull(best)
            // The same cone may be described from its dark side; of shapes that nothing describes that says less.
            val good = all.filter { it.residual < GOOD }.ifEmpty { all }
            return good.filter { it.isLitAtAxis }.minByOrNull { it.residual } ?: good.minByOrNull { it.residual }
        }

        private fun centroid(
            directions: List<Vector3dc>,
            strengths: DoubleArray,
        ): Vector3d? {
            val finite = strengths.filter { it.isFinite() }
            if (finite.isEmpty() || finite.max() == finite.min()) return null
            val mean = finite.average()
            val sum = Vector3d()
            for (i in directions.indices) if (strengths[i].isFinite()) sum.fma(strengths[i] - mean, directions[i])
            return if (sum.length() > 0) sum.normalize() else null
        }

        private fun mean(directions: List<Vector3dc>): Vector3d? {
            val sum = directions.fold(Vector3d()) { all, it -> all.add(it) }
            return if (sum.length() > 0) sum.normalize() else null
        }

        const val DISTANCE: Double = 1.0
        private const val COARSE = 500
        private const val EVEN = 1e-4
        private const val GOOD = 1e-2

        /** Radians. */
        private const val BESIDE = 0.02
    }
}

package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.max

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

/** Follows a first guess of a cone's axis to the cone. */
internal class ConeSearch(
    private val amplitudes: Amplitudes,
    private val distance: Double,
) {
    private class Ring(
        val directions: List<Vector3d>,
        val strengths: DoubleArray,
    )

    /** The cone about an axis near [start], or null where nothing like one is found. */
    fun refine(start: Vector3dc): ConeFit? {
        var axis = Vector3d(start)
        var rings = look(axis, THETAS)
        repeat(ROUNDS) {
            val better = axisOf(rings) ?: return@repeat
            axis = better
            rings = look(axis, THETAS)
        }
        return describe(axis, rings)
    }

    /** The cone about [axis] as it is given. */
    fun about(axis: Vector3dc): ConeFit? = describe(Vector3d(axis), look(axis, THETAS))

    private fun look(
        axis: Vector3dc,
        thetas: DoubleArray,
    ): Ring {
        val directions = thetas.flatMap { theta -> List(AZIMUTHS) { Directions.around(axis, theta, 2 * PI * it / AZIMUTHS) } }
        return Ring(directions, amplitudes.along(directions, distance))
    }

    /** The direction in which the strength grows where it is neither least nor most: there it is linear in the direction. */
    private fun axisOf(ring: Ring): Vector3d? {
        val finite = ring.strengths.filter { it.isFinite() }
        if (finite.isEmpty()) return null
        val low = finite.min()
        val high = finite.max()
        val margin = 1e-4 * (high - low)
        val equations = LeastSquares(4)
        var count = 0
        for (i in ring.directions.indices) {
            val s = ring.strengths[i]
            if (!(s > low + margin && s < high - margin)) continue
            val d = ring.directions[i]
            equations.add(doubleArrayOf(d.x, d.y, d.z, 1.0), s)
            count++
        }
        if (count < 2 * AZIMUTHS) return null
        val solved = equations.solve() ?: return null
        val axis = Vector3d(solved[0], solved[1], solved[2])
        return if (axis.length() > 0) axis.normalize() else null
    }

    private fun describe(
        axis: Vector3d,
        ring: Ring,
    ): ConeFit? {
        val profile = DoubleArray(THETAS.size) { t -> (0 until AZIMUTHS).sumOf { ring.strengths[t * AZIMUTHS + it] } / AZIMUTHS }
        if (profile.any { !it.isFinite() }) return null
        val high = profile.max()
        val low = profile.min()
        if (!(high > low) || high <= 0) return null
        val uneven = ring.strengths.indices.maxOf { abs(ring.strengths[it] - profile[it / AZIMUTHS]) } / (high - low)
        val shape = ConeShape.of(axis, profile, THETAS) { thetas -> along(axis, thetas) }
        return ConeFit(
            axis, shape.cosInner, shape.cosOuter, shape.falloff, max(shape.error, uneven), THETAS,
            DoubleArray(profile.size) {
                profile[it] /
                    shape.full
            },
            max(shape.residual, uneven),
        )
    }

    private fun along(
        axis: Vector3dc,
        thetas: DoubleArray,
    ): DoubleArray = amplitudes.along(thetas.map { Directions.around(axis, it, 0.7) }, distance)

    companion object {
        private const val AZIMUTHS = 8
        private const val ROUNDS = 4

        // Denser near the axis: cones of a few degrees need it, and wide ones do not mind.
        private val THETAS = DoubleArray(90) { PI * (it / 89.0) * (it / 89.0) }
    }
}

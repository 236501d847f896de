package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.max

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

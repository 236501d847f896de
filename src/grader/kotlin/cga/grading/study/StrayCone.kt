package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.exp
import kotlin.math.ln

/**
 * A light that shines from its own place and fades with its own distance, but in a cone whose cosine is taken with the vector to another.
 *
 * @param cone about the other place, [from] in view space.
 */
internal class StrayCone private constructor(
    val cone: ConeFit,
    val attenuation: AttenuationFit,
    val from: Vector3dc,
) {
    companion object {
        /** The light that [amplitudes] measures, its cone told from the one of [candidates] (view space) that explains it; null where none does. */
        fun of(
            amplitudes: Amplitudes,
            lit: List<Vector3dc>,
            axes: List<Vector3dc>,
            candidates: List<Vector3dc>,
        ): StrayCone? {
            val own = amplitudes.placement.view
            val others = candidates.filter { it.distance(own) > APART }.distinctBy { Vector3d(it).div(APART).round() }
            return others.firstNotNullOfOrNull { of(amplitudes.toldFrom(it), own, lit, axes, it) }
        }

        private fun of(
            told: Amplitudes,
            own: Vector3dc,
            lit: List<Vector3dc>,
            axes: List<Vector3dc>,
            from: Vector3dc,
        ): StrayCone? {
            val around = Directions.sphere(DIRECTIONS)
            val seen = told.along(around, ConeFit.DISTANCE)
            val brightest = around.indices.filter { seen[it] > 0 }.maxByOrNull { seen[it] } ?: return null
            val law = law(told, own, around[brightest]) ?: return null
            val cone = ConeFit.of(told.without(law), lit, axes)?.takeIf { it.residual < EXACT } ?: return null
            val full = law(told, own, cone.brightest) ?: return null
            return StrayCone(cone, AttenuationFit(full.k, full.error, full.growing, full.distances, full.strengths), from)
        }

        /** What it fades with along a ray on which the cone is everywhere the same, by the distance from its [own] place. */
        private fun law(told: Amplitudes, own: Vector3dc, direction: Vector3dc): AttenuationFit? {
            val reach = DoubleArray(STEPS) { exp(ln(NEAR) + (ln(FAR) - ln(NEAR)) * it / (STEPS - 1)) }
            val points = reach.map { told.placement.at(Vector3d(direction).mul(it)) }
            val distances = DoubleArray(STEPS) { points[it].distance(own) }
            val law = AttenuationFit.of(distances, told.at(points), growing = false, own)
            return law.takeIf { it.error < AttenuationFit.ACCEPTED && minOf(it.k.x(), it.k.y(), it.k.z()) >= 0 }
        }

        private const val DIRECTIONS = 500
        private const val STEPS = 28

        /** View-space units. */
        private const val NEAR = 0.2
        private const val FAR = 30.0
        private const val APART = 1e-2

        /** Relative to full light. */
        private const val EXACT = 5e-3
    }
}

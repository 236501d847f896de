package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A light with a cone whose cosine is that with the direction to another light.
 *
 * @param amplitudes of the light as told from where its [cone] and its distances are measured.
 */
internal class StrayBeam private constructor(
    val amplitudes: Amplitudes,
    val cone: ConeFit,
    val attenuation: AttenuationFit,
) {
    companion object {
        /** The light that [amplitudes] measures, told from the one of [candidates] (view space) that explains it; null where none does. */
        fun of(
            amplitudes: Amplitudes,
            lit: List<Vector3dc>,
            axes: List<Vector3dc>,
            candidates: List<Vector3dc>,
        ): StrayBeam? {
            val other = candidates.filter { it.distance(amplitudes.placement.view) > APART }.distinctBy { Vector3d(it).div(APART).round() }
            return other.firstNotNullOfOrNull { of(amplitudes.toldFrom(it), lit, axes, it) }
        }

        private fun of(
            amplitudes: Amplitudes,
            lit: List<Vector3dc>,
            axes: List<Vector3dc>,
            from: Vector3dc,
        ): StrayBeam? {
            if (!isSeparable(amplitudes)) return null
            val cone = ConeFit.of(amplitudes, lit, axes)?.takeIf { it.residual < EXACT } ?: return null
            val law = AttenuationFit.of(amplitudes, cone.brightest)
            if (law.error > AttenuationFit.ACCEPTED) return null
            return StrayBeam(amplitudes, cone, AttenuationFit(law.k, law.error, law.growing, law.distances, law.strengths, from))
        }

        /** Whether the light falls off alike in all directions that it shines to: a cone times a law of distance, and nothing of any other place. */
        private fun isSeparable(amplitudes: Amplitudes): Boolean {
            val around = Directions.sphere(DIRECTIONS)
            val (near, far) = listOf(1.0, 2.0).map { amplitudes.along(around, ConeFit.DISTANCE * it) }
            val faint = FAINT * near.largest()
            val ratios = around.indices.filter { near[it] > faint }.map { far[it] / near[it] }
            return ratios.size >= FEWEST && ratios.max() - ratios.min() < EXACT * ratios.max()
        }

        private const val DIRECTIONS = 500
        private const val FEWEST = 4

        /** Relative to the brightest: below it floats tell no ratio. */
        private const val FAINT = 0.01

        /** View space units. */
        private const val APART = 1e-2

        /** Relative to full light: about any other place the profile is none of an angle. */
        private const val EXACT = 5e-3
    }
}

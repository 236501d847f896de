package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI
import kotlin.math.exp
import kotlin.math.ln
import kotlin.random.Random

/** A light with a [cone] of its own that fades with the distance from another place. */
internal class StrayDistance private constructor(
    val cone: ConeFit,
    val attenuation: AttenuationFit,
) {
    companion object {
        /**
         * The light that [amplitudes] measures, where [seen] is its cone as if it faded with its own distance, from the one of [candidates]
         * (view space) that explains it; null where none does.
         */
        fun of(
            amplitudes: Amplitudes,
            seen: ConeFit,
            lit: List<Vector3dc>,
            axes: List<Vector3dc>,
            candidates: List<Vector3dc>,
        ): StrayDistance? {
            val random = Random(21)
            val points = List(POINTS) {
                val direction = Directions.around(seen.axis, random.nextDouble() * seen.inner * WELL_INSIDE, random.nextDouble(2 * PI))
                amplitudes.placement.at(direction.mul(exp(random.nextDouble(ln(NEAR), ln(FAR)))))
            }
            val law = AttenuationFit.fromElsewhere(amplitudes, candidates, points) ?: return null
            val cone = ConeFit.of(amplitudes.without(law), lit, axes)?.takeIf { it.residual < EXACT } ?: return null
            return StrayDistance(cone, law)
        }

        private const val POINTS = 112
        private const val WELL_INSIDE = 0.3

        /** View-space units. */
        private const val NEAR = 0.2
        private const val FAR = 30.0

        /** Relative to full light. */
        private const val EXACT = 5e-3
    }
}

package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt
import kotlin.random.Random

/**
 * 1/(K_c + K_l·d + K_q·d²) fitted to what a light does with distance.
 *
 * @param k of a light of colour (1, 1, 1), all as if a factor of the whole were part of it.
 * @param error largest difference from the fit, relative to the strength there.
 * @param from where the distances are measured from in view space, where that is not the place that the directions come from.
 * @param growing whether the strength is that of a direction of length d: never normalised.
 * @param isTwice whether the strength is the square of the factor with this K.
 */
internal class AttenuationFit(
    val k: Vector3dc,
    val error: Double,
    val growing: Boolean,
    val distances: DoubleArray,
    val strengths: DoubleArray,
    val from: Vector3dc? = null,
    val isTwice: Boolean = false,
) {
    val isConstant: Boolean get() = k.y() == 0.0 && k.z() == 0.0
    val isLinear: Boolean get() = k.z() == 0.0 && k.y() > 0

    /** The strength at the distance [d]. */
    fun factor(d: Double): Double = ((if (growing) d else 1.0) / (k.x() + k.y() * d + k.z() * d * d)).let { if (isTwice) it * it else it }

    companion object {
        /** Looks along [axis] (in the placement's space), or into many directions where a light has none. */
        fun of(
            amplitudes: Amplitudes,
            axis: Vector3dc?,
        ): AttenuationFit {
            val random = Random(5)
            val distances = DoubleArray(STEPS) { exp(ln(NEAR) + (ln(FAR) - ln(NEAR)) * it / (STEPS - 1)) }
            val points = distances.map { d -> amplitudes.placement.at(Vector3d(axis ?: Directions.random(random)).mul(d)) }
            val strengths = amplitudes.at(points)
            val right = of(distances, strengths, growing = false)
            if (right.error < ACCEPTED) return right
            val best = listOf(right, of(distances, strengths, growing = true), twice(distances, strengths)).minBy { it.error }
            return if (best.error < ACCEPTED || axis != null) best else growing(amplitudes) ?: best
        }

        /** A long vector to the light that also cuts the light off to one side is still seen to another. */
        private fun growing(amplitudes: Amplitudes): AttenuationFit? =
            Directions.AXES.firstNotNullOfOrNull { axis -> of(amplitudes, axis).takeIf { it.growing && it.error < ACCEPTED } }

        /** The law whose square the [strengths] are; none of a law with negative terms, which a square may well look like. */
        private fun twice(
            distances: DoubleArray,
            strengths: DoubleArray,
        ): AttenuationFit {
            val root = of(distances, DoubleArray(strengths.size) { sqrt(strengths[it]) }, growing = false)
            val error = if (minOf(root.k.x(), root.k.y(), root.k.z()) < 0) 1.0 else 2 * root.error
            return AttenuationFit(root.k, error, growing = false, distances, strengths, isTwice = true)
        }

        /**
         * The law of a light whose directions come from one place and whose distances are measured from another, one of [candidates] in view
         * space; null where none of them explains it.
         */
        fun fromElsewhere(
            amplitudes: Amplitudes,
            candidates: List<Vector3dc>,
        ): AttenuationFit? {
            val random = Random(13)
            val points =
                List(4 * STEPS) { amplitudes.placement.at(Directions.random(random).mul(exp(random.nextDouble(ln(NEAR), ln(FAR))))) }
            return fromElsewhere(amplitudes, candidates, points)
        }

        /** The same by what arrives at [points], in view space. */
        fun fromElsewhere(
            amplitudes: Amplitudes,
            candidates: List<Vector3dc>,
            points: List<Vector3d>,
        ): AttenuationFit? {
            val strengths = amplitudes.at(points)
            val fits = candidates.map { c -> of(DoubleArray(points.size) { points[it].distance(c) }, strengths, growing = false, c) }
            return fits.minByOrNull { it.error }?.takeIf { it.error < ACCEPTED }
        }

        fun of(
            distances: DoubleArray,
            strengths: DoubleArray,
            growing: Boolean,
            from: Vector3dc? = null,
        ): AttenuationFit {
            val k = solve(distances, strengths, growing)
            val fit = AttenuationFit(k, 0.0, growing, distances, strengths)
            val error = distances.indices.maxOf { i ->
                (abs(fit.factor(distances[i]) / strengths[i] - 1)).let { if (it.isNaN()) 1.0 else it }
            }
            return AttenuationFit(k, error, growing, distances, strengths, from)
        }

        /** Fits all three; a term that matters nowhere in the range is left out, and the others fitted again. */
        private fun solve(
            distances: DoubleArray,
            strengths: DoubleArray,
            growing: Boolean,
        ): Vector3d {
            var terms = listOf(0, 1, 2)
            while (true) {
                val equations = LeastSquares(terms.size)
                for (i in distances.indices) {
                    val a = strengths[i] / if (growing) distances[i] else 1.0
                    equations.add(DoubleArray(terms.size) { a * power(distances[i], terms[it]) }, 1.0)
                }
                val solved = equations.solve() ?: return Vector3d(1.0, 0.0, 0.0)
                val shares =
                    terms.indices.map { t ->
                        distances.indices.maxOf {
                            abs(solved[t]) * power(distances[it], terms[t]) * strengths[it] /
                                if (growing) distances[it] else 1.0
                        }
                    }
                val least = shares.indices.minBy { shares[it] }
                if (shares[least] > NEGLIGIBLE || terms.size == 1) {
                    val k = Vector3d()
                    terms.forEachIndexed { t, term -> k.setComponent(term, solved[t]) }
                    return k
                }
                terms = terms - terms[least]
            }
        }

        private fun power(
            d: Double,
            exponent: Int,
        ) = if (exponent == 0) {
            1.0
        } else if (exponent == 1) {
            d
        } else {
            d * d
        }

        // Strengths are good to some 1e-6, relative; three unknowns from 28 of them to a hundred times that.
        const val ACCEPTED: Double = 1e-3
        private const val NEGLIGIBLE = 2e-4
        private const val STEPS = 28
        private const val NEAR = 0.2
        private const val FAR = 30.0
    }
}

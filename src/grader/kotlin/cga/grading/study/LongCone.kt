package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.pow

/** A cone whose cosine is taken with the vector to the light at its full length d, as d·cos θ: it is the wider the farther it reaches. */
internal object LongCone {
    /** What the light fades with where [seen], its cone at the distance 1, turns out to be such a one; null where it does not. */
    fun law(
        amplitudes: Amplitudes,
        seen: ConeFit,
    ): AttenuationFit? {
        if (seen.residual > UNEVEN || seen.cosOuter <= 0) return null
        // Beyond 1 the axis is lit fully.
        val distances = DoubleArray(STEPS) { FAR.pow(it / (STEPS - 1.0)) }
        val law = AttenuationFit.of(distances, amplitudes.at(distances.map { point(amplitudes, seen.axis, it) }), growing = false)
        if (law.error > AttenuationFit.ACCEPTED) return null
        val half = (seen.cosInner + seen.cosOuter) / 2
        val isHalf = LENGTHS.all { d -> abs(intensity(amplitudes, seen, law, d, half / d) - 0.5) < UNEVEN }
        return law.takeIf { isHalf }
    }

    /** I at the distance [d], where the angle to the axis has the [cosine]. */
    private fun intensity(
        amplitudes: Amplitudes,
        seen: ConeFit,
        law: AttenuationFit,
        d: Double,
        cosine: Double,
    ): Double {
        val direction = Directions.around(seen.axis, acos(cosine.coerceAtMost(1.0)), AROUND)
        return amplitudes.at(listOf(point(amplitudes, direction, d))).single() / law.factor(d)
    }

    private fun point(
        amplitudes: Amplitudes,
        direction: Vector3dc,
        d: Double,
    ) = amplitudes.placement.at(Vector3d(direction).mul(d))

    /** Relative to full light. */
    private const val UNEVEN = 1e-2
    private const val STEPS = 12
    private const val FAR = 30.0
    private const val AROUND = 0.7
    private val LENGTHS = listOf(1.5, 2.0, 4.0)
}

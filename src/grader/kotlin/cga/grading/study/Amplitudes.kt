package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI

/** The term by which a light is measured, and so the normals for which a point is brightest and dark. */
internal enum class Peak {
    DIFFUSE,

    /** Diffuse light that sides facing away receive as well. */
    TWO_SIDED,

    /** Diffuse light by a power of the cosine. */
    POWER,
    SPECULAR,
}

/**
 * How strongly a placed light arrives at points, whatever the normal there: I·F of the lighting model.
 *
 * @param placement what points are told from.
 * @param unclamped whether sides that look away receive negative light; then the range is twice the strength.
 * @param facing what normals are turned to, where the light's directions come from elsewhere.
 * @param law what the light fades with, where that is to be left out: with the distance from its place `from`.
 */
internal class Amplitudes(
    private val probe: LightProbe,
    val placement: Placement,
    private val texels: Map<String, Double>,
    val unclamped: Boolean,
    private val peak: Peak = Peak.DIFFUSE,
    private val facing: Placement = placement,
    private val law: AttenuationFit? = null,
) {
    /** The same light, told from [view] in view space. */
    fun toldFrom(view: Vector3dc): Amplitudes = Amplitudes(probe, placement.movedTo(view), texels, unclamped, peak, facing)

    /** The same light as if it did not fade by [law]. */
    fun without(law: AttenuationFit): Amplitudes = Amplitudes(probe, placement, texels, unclamped, peak, facing, law)

    /** I·F at [points] in view space. */
    fun at(points: List<Vector3dc>): DoubleArray {
        val samples =
            points.flatMap { p ->
                val towards = towards(facing, p, peak)
                if (facing.isFlipped) towards.negate()
                val dark = if (peak == Peak.DIFFUSE) Vector3d(towards).negate() else Directions.around(towards, PI / 2, 0.3)
                listOf(towards, dark).map { Sample(p, facing.normalFor(it)) }
            }
        val shades = probe.shade(samples, texels)
        val range = if (unclamped) 2.0 else 1.0
        return DoubleArray(points.size) { (shades[2 * it] - shades[2 * it + 1]) / range / faded(points[it]) }
    }

    private fun faded(point: Vector3dc) = law?.from?.let { law.factor(it.distance(point)) } ?: 1.0

    /** I·F at the distance [d] from the light along [direction], in the placement's own space. */
    fun along(
        directions: List<Vector3dc>,
        d: Double,
    ): DoubleArray = at(directions.map { placement.at(Vector3d(it).mul(d)) })

    companion object {
        /** The normal for which the term [peak] is largest at [p], in the space of [placement]: to the light, or half way to the eye. */
        fun towards(
            placement: Placement,
            p: Vector3dc,
            peak: Peak,
        ): Vector3d {
            val l = placement.toLight(p).normalize()
            return if (peak == Peak.SPECULAR) l.add(placement.toCamera(p).normalize()).normalize() else l
        }
    }
}

package cga.measure.accuracy.hard

import cga.exercise.components.light.PointLight
import cga.framework.FrameCone
import cga.framework.SpecularModel
import cga.reference.LightContribution
import cga.reference.ShadedPoint
import org.joml.Vector3fc
import kotlin.math.abs

/** How far a shot's pixel may be from the truth; see [Rounding]. */
internal object ShotBound {
    /** The bound for all three channels; null where rounding decides between two values, or the truth is beyond what floats can say. */
    fun of(
        shot: Shot,
        truth: ShadedPoint,
    ): Double? {
        if (shot.position.length() !in EYE || largest(shot.normal) in DENORMAL) return null
        val bounds = shot.lights.indices.map { i -> light(shot, truth, truth.lights[i], shot.lights[i]) ?: return null }
        return bounds.sum() + SMALLEST
    }

    private fun light(
        shot: Shot,
        truth: ShadedPoint,
        share: LightContribution,
        light: PointLight,
    ): Double? {
        if (share.distance == 0.0) return 0.0
        if (share.distance !in LIGHT || largest(light.attenuation) !in FACTOR) return null
        val h = Rounding.sumLength(share, truth.toCamera)
        val phong = shot.specularModel == SpecularModel.PHONG
        if (!phong && h < 1e-5) return null
        val cosBeta = if (phong) Rounding.PHONG_COSINE else Rounding.halfCosine(h)
        // With an exponent near 0 the highlight is a step at the edge of its half space.
        if (shot.specular > 0f && shot.k < 1f && abs(share.cosBeta) < STEP) return null
        val highlight = highlight(shot.k.toDouble(), cosBeta, share.cosBeta)
        // So large an exponent that rounding decides whether there is a highlight at all.
        if (shot.specular > 0f && highlight > 0.5) return null
        val cone = light.toFrameLight().cone?.let { cone(it, share) ?: return null } ?: 0.0
        val reflected = shot.diffuse * Rounding.COSINE + shot.specular * highlight + 2 * (Rounding.ATTENUATION + Rounding.PRODUCTS + cone)
        return share.attenuation * largest(light.lightColor) * reflected
    }

    private fun cone(
        cone: FrameCone,
        share: LightContribution,
    ): Double? {
        val inner = cone.innerAngle.toDouble()
        val outer = cone.outerAngle.toDouble()
        val bound = Rounding.cone(inner, outer)
        // Cones narrower than what a float direction can say are steps.
        return if (bound.isNaN() || bound > 0.5) 0.0.takeIf { abs(share.theta - outer) > 0.01 } else bound
    }

    /** A power with an exponent below 1 is steep near a cosine of 0, one above 1 near 1. */
    private fun highlight(
        k: Double,
        cosine: Double,
        cosBeta: Double,
    ): Double = if (k >= 1) Rounding.highlight(cosine, k) else Rounding.highlight(cosine / maxOf(cosBeta, STEP), k)

    private fun largest(v: Vector3fc) = maxOf(abs(v.x()), abs(v.y()), abs(v.z()))

    private operator fun ClosedFloatingPointRange<Float>.contains(x: Double) = x >= start && x <= endInclusive

    /** Distances whose squares and their products are ordinary floats. */
    private val EYE = 1e-15f..1e15f
    private val LIGHT = 1e-15f..1e15f
    private val DENORMAL = Float.MIN_VALUE..1e-30f
    private val FACTOR = 1e-6f..1e6f
    private const val STEP = 1e-3

    /** Products below the smallest normal float may become 0. */
    private const val SMALLEST = 1e-37
}

package cga.grading.study

import org.joml.Vector3dc

/**
 * What the shaders make of one light.
 *
 * @param placement where it is; null where its directions do not meet anywhere.
 * @param unclamped whether sides that look away receive negative light.
 * @param normalLength how bright a normal of half the length is: 1 where normals are normalised, 1/2 where never.
 * @param cosineError what a clamped cosine leaves of the diffuse term, relative.
 * @param otherDirection whether its distances are measured from elsewhere than its directions.
 * @param shared the lights that take this one's colour, if there is more than one.
 * @param isFromEye whether the diffuse cosine is that with the direction to the eye.
 * @param hasLongCone whether its cone is the wider the farther it reaches.
 * @param hasStrayCone whether its cone is about another place than its own.
 * @param guess where it may be in view space, if it could not be placed.
 * @param floor how much of the light arrives whatever the normal, relative to its strength: ambient light of its own.
 */
internal class LightModel(
    val probe: LightProbe,
    val placement: Placement?,
    val unclamped: Boolean,
    val normalLength: Double,
    val cosineError: Double,
    val floor: Double,
    val attenuation: AttenuationFit?,
    val cone: ConeFit?,
    val highlight: HighlightModel?,
    val diffuseInterpolation: InterpolationTest?,
    val specularInterpolation: InterpolationTest?,
    val otherDirection: Boolean = false,
    val shared: List<SharedLight> = emptyList(),
    val guess: Vector3dc? = null,
    val isFromEye: Boolean = false,
    val hasLongCone: Boolean = false,
    val hasStrayCone: Boolean = false,
) {
    val name: String get() = probe.slot.text

    /** Whether its distances are measured from the camera. */
    val fadesFromEye: Boolean get() = !isFromEye && attenuation?.from?.let { it.length() < NEAR_EYE } == true

    companion object {
        private const val NEAR_EYE = 1e-3

        /** A light that could not be placed as one: several that have its colour, or one that may be at [guess] in view space. */
        fun unplaced(
            probe: LightProbe,
            shared: List<SharedLight>,
            guess: Vector3dc?,
        ): LightModel = LightModel(probe, null, false, 1.0, 1.0, 0.0, null, null, null, null, null, shared = shared, guess = guess)
    }
}

/** One of several lights of a common colour. */
internal class SharedLight(
    val view: Vector3dc,
    val attenuation: AttenuationFit?,
)

/**
 * The specular term of one light.
 *
 * @param exponentSlot the uniform that the exponent follows, null where none does.
 */
internal class HighlightModel(
    val fit: HighlightFit,
    val limits: HighlightLimits,
    val exponentSlot: ExponentSlot?,
)

/**
 * What scales the specular term, each as the relative misfit of a hypothesis: 0 is a perfect fit.
 *
 * @param all attenuation and cone, as it should be; and so on.
 */
internal class HighlightLimits(
    val all: Double,
    val coneOnly: Double,
    val attenuationOnly: Double,
    val nothing: Double,
) {
    val best: Double get() = minOf(minOf(all, coneOnly), minOf(attenuationOnly, nothing))
}

/** A point at which the strengths of a light's two terms are compared. */
internal class StrengthPoint(
    val position: Vector3dc,
    val distance: Double,
    val cosine: Double,
)

/** A number among those of the uniform [name]. */
internal class ExponentSlot(
    val name: String,
    val component: Int,
)

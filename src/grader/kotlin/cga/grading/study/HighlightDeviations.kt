package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Mistake

/** What is wrong with a light's specular term. */
internal object HighlightDeviations {
    /** The mistakes in the highlight of [light]. */
    fun of(
        light: LightModel,
        study: ProgramStudy,
    ): List<Deviation> {
        if (study.roles?.specular == null) return emptyList()
        val highlight = light.highlight ?: return listOf(Deviation(Mistake.SPECULAR_MISSING, light.name, 0.0, 1.0))
        val fit = highlight.fit
        if (fit.error > TOLERATED) return listOf(Deviation(Mistake.UNKNOWN, light.name, fit.error, fit.error, check = Check.SPECULAR))
        // The same for all normals, and not of one strength: a power, but of something else than a cosine with the normal.
        if (fit.exponent < NO_EXPONENT && !light.otherDirection && highlight.limits.best > UNLIMITED) {
            return listOf(Deviation(Mistake.UNKNOWN, light.name, fit.error, 1.0, check = Check.SPECULAR))
        }
        val mistakes =
            listOfNotNull(
                Mistake.VIEW_VECTOR_SIGN.takeIf {
                    fit.eye == EyeVector.REVERSED ||
                        (fit.lightReversed && light.placement?.isFlipped == false)
                },
                Mistake.UNKNOWN.takeIf { fit.eye != EyeVector.REVERSED && !isRightEye(light, fit) },
                Mistake.PHONG_LEFT.takeIf { fit.lobe == Lobe.PHONG },
                Mistake.HALF_VECTOR_NOT_NORMALIZED.takeIf { fit.lobe == Lobe.BLINN_LONG || fit.lobe == Lobe.BLINN_RAW },
                Mistake.SPECULAR_CLAMP_MISSING.takeIf { fit.unclamped },
                exponent(highlight, study),
            ) + if (light.otherDirection) emptyList() else limits(light, highlight.limits)
        return mistakes.map { Deviation(it, light.name, fit.error, 1.0, check = if (it == Mistake.UNKNOWN) Check.SPECULAR else it.check) }
    }

    private fun exponent(
        highlight: HighlightModel,
        study: ProgramStudy,
    ): Mistake? {
        if (highlight.exponentSlot != null && highlight.fit.exponent >= NO_EXPONENT) return null
        // With the exponent at the other cosine either that or the vectors of both are exchanged: the textures tell.
        val isExchanged = study.roles?.let { it.peak == Peak.POWER && MaterialDeviations.isSwapped(it, study.samplers.files) } == true
        return if (isExchanged) Mistake.UNKNOWN else Mistake.EXPONENT_FIXED
    }

    /** With the light in one space and the normals in another the eye may be right in either: that is one mistake, and named already. */
    private fun isRightEye(
        light: LightModel,
        fit: HighlightFit,
    ) = fit.eye == EyeVector.RIGHT || (fit.eye == EyeVector.VIEW_AXES && light.placement?.isConsistent == false)

    private fun limits(
        light: LightModel,
        limits: HighlightLimits,
    ): List<Mistake> {
        if (limits.best > UNLIMITED) return listOf(Mistake.UNKNOWN)
        if (limits.all <= limits.best * 1.5 + TOLERATED) return emptyList()
        val isSpot = light.cone != null
        return when (limits.best) {
            limits.attenuationOnly -> listOf(Mistake.SPECULAR_NOT_CONED)
            limits.coneOnly -> listOf(Mistake.ATTENUATION_ON_DIFFUSE_ONLY)
            else -> listOfNotNull(Mistake.ATTENUATION_ON_DIFFUSE_ONLY, Mistake.SPECULAR_NOT_CONED.takeIf { isSpot })
        }
    }

    // An exponent that was never sent is 0.
    private const val NO_EXPONENT = 1e-3
    private const val TOLERATED = 0.01
    private const val UNLIMITED = 0.1
}

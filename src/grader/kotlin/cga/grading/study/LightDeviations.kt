package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import kotlin.math.abs

/** What is wrong with the shading of a light, beside its cone. */
internal object LightDeviations {
    /** The mistakes in [light]. */
    fun of(
        light: LightModel,
        study: ProgramStudy,
    ): List<Deviation> {
        val placement = light.placement ?: return unplaced(light, study)
        val found = mutableListOf<Deviation>()

        fun add(
            mistake: Mistake,
            fit: Double,
            difference: Double = 1.0,
        ) {
            found += Deviation(mistake, light.name, fit, difference)
        }
        if (study.normalsMoved) add(Mistake.NORMAL_MATRIX, placement.error)
        if (!placement.isConsistent) add(alone(light, placement), placement.error)
        if (RefFinder(light, study).detour(placement.view) != null) add(Mistake.TO_LIGHT_WORLD, placement.error)
        if (placement.isFlipped) add(Mistake.LIGHT_VECTOR_SIGN, light.cosineError)
        if (light.unclamped) add(Mistake.CLAMP_MISSING, light.cosineError)
        if (light.cosineError > TOLERATED) add(Mistake.UNKNOWN, light.cosineError, light.cosineError)
        val early = isNormalizedEarly(light)
        if (early) add(Mistake.NORMALIZED_IN_VERTEX_SHADER, 0.0, vectorDifference(light))
        if (hasLongNormals(light)) {
            add(
                Mistake.NORMAL_NOT_RENORMALIZED,
                0.0,
                maxOf(
                    1 - light.normalLength,
                    light.diffuseInterpolation?.normals ?: 0.0,
                ),
            )
        }
        attenuation(light, study)?.let { (mistake, fit) ->
            val why = if (mistake == Mistake.UNKNOWN) attenuationText(light, study) else ""
            found += Deviation(mistake, light.name, fit, 1.0, check = attenuationCheck(light, mistake, study), why = why)
        }
        val highlight = if (isStrange(light)) emptyList() else HighlightDeviations.of(light, study)
        val isTold = !isLawless(light) || study.shining.all(::isLawless)
        return found + highlight.filter { isTold || it.mistake != Mistake.UNKNOWN }
    }

    /**
     * Which is in a space of its own, the normal or the vector to the light: where the one to the eye is in the light's space, the normal.
     * Where nothing tells, a normal in view space is where the sheet wants it.
     */
    private fun alone(
        light: LightModel,
        placement: Placement,
    ): Mistake =
        if (placement.path == NormalPath.VIEW && light.highlight?.fit?.eye != EyeVector.RIGHT) {
            Mistake.TO_LIGHT_WORLD
        } else {
            Mistake.NORMAL_MATRIX
        }

    /** Without a diffuse term there is nothing to place a light by: that is said once, of the program. */
    private fun unplaced(
        light: LightModel,
        study: ProgramStudy,
    ): List<Deviation> =
        when {
            study.roles?.diffuse == null -> emptyList()
            light.shared.isNotEmpty() -> listOf(Deviation(Mistake.LATER_LIGHTS_FIRST_COLOR, light.name, light.cosineError, 1.0))
            else -> listOf(Deviation(Mistake.UNKNOWN, light.name, 1.0, 1.0))
        }

    /** Whether vectors are bent between the corners of triangles. */
    fun isNormalizedEarly(light: LightModel): Boolean = vectorDifference(light) > INTERPOLATED

    /** Whether nothing is left of the distance because the vector was normalised too early: then its length is 1, which is one defect and not two. */
    fun isAtLengthOne(light: LightModel): Boolean =
        light.attenuation?.let { it.isConstant && abs(it.k.x() - 1) > 1e-3 } == true && isNormalizedEarly(light)

    private fun vectorDifference(light: LightModel): Double =
        maxOf(light.diffuseInterpolation?.vectors ?: 0.0, light.specularInterpolation?.vectors ?: 0.0)

    private fun hasLongNormals(light: LightModel): Boolean =
        abs(light.normalLength - 1) > 0.02 || (light.diffuseInterpolation?.normals ?: 0.0) > INTERPOLATED

    private fun attenuationCheck(
        light: LightModel,
        mistake: Mistake,
        study: ProgramStudy,
    ) = when {
        mistake != Mistake.UNKNOWN || light.isFromEye -> mistake.check
        // The formula is right, and what is put into it another light's.
        light.cone != null && study.distanceOf(light) != null -> Check.ATTENUATION_SPOT
        // Two and more are right: then the formula is, and these are further lights.
        isStrange(light) && study.shining.count { !isStrange(it) } >= 2 -> Check.MORE_LIGHTS_SHADING
        else -> Check.ATTENUATION_FORM
    }

    /** Whether no law of distance comes near what [light] does: then its highlight cannot be told from how it fades. */
    fun isLawless(light: LightModel): Boolean = light.attenuation?.error?.let { it >= LAWLESS } == true

    /** Whether [light] is dark where it should shine by any law of distance: nothing else that was measured of it means anything. */
    fun isStrange(light: LightModel): Boolean = light.cone == null && light.attenuation?.error?.isInfinite() == true

    private fun attenuationText(
        light: LightModel,
        study: ProgramStudy,
    ): String {
        val copied = study.distanceOf(light)
        return when {
            light.fadesFromEye -> "it fades with the camera's distance"
            copied != null -> "it fades with the distance of ${copied.name}"
            light.attenuation?.isTwice == true && !isLawless(light) -> "it fades with the square of F"
            else -> ""
        }
    }

    private fun attenuation(
        light: LightModel,
        study: ProgramStudy,
    ): Pair<Mistake, Double>? {
        val fit = light.attenuation ?: return null
        return when {
            light.otherDirection && light.isFromEye -> Mistake.UNKNOWN to fit.error
            light.fadesFromEye -> Mistake.UNKNOWN to fit.error
            isAcrossSpaces(light, study) -> Mistake.TO_LIGHT_WORLD to fit.error
            study.distanceOf(light) != null -> Mistake.UNKNOWN to fit.error
            light.otherDirection || study.directionOf(light) != null -> Mistake.LATER_LIGHTS_FIRST_COSINE to fit.error
            fit.error > AttenuationFit.ACCEPTED || fit.isTwice -> Mistake.UNKNOWN to fit.error
            fit.growing -> Mistake.TO_LIGHT_NOT_NORMALIZED to fit.error
            isAtLengthOne(light) -> null
            fit.isConstant -> Mistake.ATTENUATION_MISSING to fit.error
            fit.isLinear -> Mistake.ATTENUATION_LINEAR to fit.error
            else -> null
        }
    }

    /** Whether [light] fades with the distance from its place in the world to a point in view space. */
    private fun isAcrossSpaces(
        light: LightModel,
        study: ProgramStudy,
    ): Boolean {
        val from = light.attenuation?.from ?: return false
        val place = light.placement?.view ?: return false
        val world = study.box.spaces.view?.back(place) ?: return false
        return from.distance(world) < 1e-3 * (1 + world.length()) && from.distance(place) > APART
    }

    /** What floats and a triangle's middle leave is below 1e-4; a wrong vector changes a tenth and more. */
    private const val INTERPOLATED = 0.01
    private const val TOLERATED = 5e-3
    private const val LAWLESS = 0.5

    /** View-space units. */
    private const val APART = 1e-2
}

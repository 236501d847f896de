package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Mistake
import cga.grading.rubric.spoiltBy
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import kotlin.math.abs
import kotlin.math.max

/** All that is wrong with what a program computes. */
internal object ProgramDeviations {
    /**
     * The mistakes found, each once with all the lights that have it; the first explain most. What has no name explains what is measured
     * by way of that which it spoils.
     */
    fun of(study: ProgramStudy): List<Found> =
        all(study).groupBy { it.mistake }.map { (mistake, same) ->
            val where = same.map { it.light }.filter { it.isNotEmpty() }.distinct().joinToString(", ")
            val spoilt = if (mistake == Mistake.UNKNOWN) spoilt(same.map { it.check }.toSet()) else null
            Found(mistake, same.maxOf { it.fit }, same.maxOf { it.difference }, where, same.first().alternatives, spoilt)
        }

    private fun spoilt(seen: Set<Check>) = seen.flatMap(::spoiltBy).toSet() - seen

    /** What is wrong and has no name. */
    fun unnamed(study: ProgramStudy): List<Deviation> = all(study).filter { it.mistake == Mistake.UNKNOWN }

    private fun all(study: ProgramStudy): List<Deviation> {
        val sent = study.numbersSent() + study.box.program.constants.values.flatMap { it.toList() }.map { it.toDouble() }
        val ofLights = study.shining.flatMap { LightDeviations.of(it, study) + cone(it, study, sent) }
        // Clamped is only the sum: what each light takes away is missing from the others.
        val sum = if (study.colors.isSumClamped) listOf(Deviation(Mistake.CLAMP_MISSING, "", 0.0, 1.0)) else emptyList()
        return ofLights + sum + silent(study) + MaterialDeviations.of(study) + emission(study) + view(study) + mesh(study)
    }

    private fun cone(
        light: LightModel,
        study: ProgramStudy,
        sent: List<Double>,
    ): List<Deviation> =
        if (light in study.coneless.forgotten || (study.isAwake && isMadeUp(light, sent)) || isOfZeros(light, study)) {
            listOf(Deviation(Mistake.CONE_NEVER_SENT, light.name, 0.0, 1.0))
        } else {
            ConeDeviations.of(light, sent, lengths(light, study))
        }

    private fun lengths(
        light: LightModel,
        study: ProgramStudy,
    ): List<Double> {
        val cone = light.cone ?: return emptyList()
        val axis = light.placement?.directionToView(cone.axis) ?: return emptyList()
        return RefFinder(light, study).lengthsAlong(axis)
    }

    /** Whether [light] has a cone of which nothing was sent: it is one of the values that had to be given to see any light. */
    private fun isMadeUp(
        light: LightModel,
        sent: List<Double>,
    ): Boolean = light.cone?.let { ConeWords.of(it.cosInner, it.cosOuter, sent) == null } == true

    /** Whether [light] has a cone between two cosines of 0, as they are where nothing was sent: light before it, and none behind. */
    private fun isOfZeros(
        light: LightModel,
        study: ProgramStudy,
    ): Boolean {
        val cone = light.cone ?: return false
        if (cone.falloff != Falloff.HARD || max(abs(cone.cosInner), abs(cone.cosOuter)) > NONE) return false
        val unsent = study.box.program.uniforms.filter { !it.isSampler && study.box.values[it.name]?.all { part -> part == 0f } == true }
        return unsent.any { it.type == GL_FLOAT || it.type == GL_FLOAT_VEC2 }
    }

    /** Spotlights that were given a colour and no cone. */
    private fun silent(study: ProgramStudy): List<Deviation> =
        study.silent
            .filter { it.hasCone && it.missing.isNotEmpty() }
            .map { Deviation(Mistake.CONE_NEVER_SENT, it.slot.text, 0.0, 1.0) }

    private fun emission(study: ProgramStudy): List<Deviation> =
        when (study.emission.form) {
            EmissionForm.TINTED ->
                when {
                    !study.isGlowEncoded -> listOf(Deviation(Mistake.UNKNOWN, "", 0.0, 1.0, check = Check.EMISSION, why = AFTER_GAMMA))
                    isRepeated(study) -> listOf(Deviation(Mistake.UNKNOWN, "", 0.0, 1.0, check = Check.EMISSION))
                    else -> emptyList()
                }
            EmissionForm.PRODUCT -> listOf(Deviation(Mistake.UNKNOWN, "", 0.0, 1.0, check = Check.EMISSION, why = PRODUCT))
            EmissionForm.ALL_TINTED -> listOf(Deviation(Mistake.COLOR_ON_EVERYTHING, "", 0.0, 1.0))
            EmissionForm.ADDED -> listOf(Deviation(Mistake.EMISSION_COLOR_ADDED, "", 0.0, 1.0))
            EmissionForm.UNTINTED -> listOf(Deviation(Mistake.EMISSION_COLOR_IGNORED, "", 0.0, 1.0))
            EmissionForm.MULTIPLIED -> listOf(Deviation(Mistake.EMISSION_MULTIPLIED, "", 0.0, 1.0))
            EmissionForm.MISSING -> listOf(Deviation(Mistake.EMISSION_MISSING, "", 0.0, 1.0))
        }

    /** Whether the emission comes in with every light, and not once. */
    fun isRepeated(study: ProgramStudy): Boolean = study.emission.isForEach(study.lights.size, study.lights.count { it.cone == null })

    private fun mesh(study: ProgramStudy): List<Deviation> =
        if (study.isOverlapping) listOf(Deviation(Mistake.UNKNOWN, "", 0.0, 1.0, check = Check.NORMALS, why = OVERLAP)) else emptyList()

    private fun view(study: ProgramStudy): List<Deviation> {
        val scale = study.box.spaces.view?.scale() ?: return emptyList()
        val error = abs(scale - 1)
        return if (error < NONE) emptyList() else listOf(Deviation(Mistake.VIEW_SCALED, "", 0.0, error))
    }

    /** Of a cosine, or of a length of 1. */
    private const val NONE = 1e-3
    private const val OVERLAP = "two vertex attributes are read from the same bytes"
    private const val PRODUCT = "the emission is multiplied with another texture"
    private const val AFTER_GAMMA = "the emission is added when the gamma has been applied already"
}

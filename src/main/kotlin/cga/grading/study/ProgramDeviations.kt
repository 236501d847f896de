package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Mistake

/** All that is wrong with what a program computes. */
internal object ProgramDeviations {
    /** The mistakes found, each once with all the lights that have it; the first explain most. */
    fun of(study: ProgramStudy): List<Found> =
        all(study).groupBy { it.mistake }.map { (mistake, same) ->
            val where = same.map { it.light }.filter { it.isNotEmpty() }.distinct().joinToString(", ")
            Found(mistake, same.maxOf { it.fit }, same.maxOf { it.difference }, where, same.first().alternatives)
        }

    /** What is wrong and has no name. */
    fun unnamed(study: ProgramStudy): List<Deviation> = all(study).filter { it.mistake == Mistake.UNKNOWN }

    private fun all(study: ProgramStudy): List<Deviation> {
        val sent = study.numbersSent() + study.box.program.constants.values.flatMap { it.toList() }.map { it.toDouble() }
        val ofLights = study.shining.flatMap { LightDeviations.of(it, study) + cone(it, study, sent) }
        return ofLights + silent(study) + material(study) + emission(study) + view(study)
    }

    private fun cone(
        light: LightModel,
        study: ProgramStudy,
        sent: List<Double>,
    ): List<Deviation> =
        if (light in study.neverConed || (study.isAwake && isMadeUp(light, sent))) {
            listOf(Deviation(Mistake.CONE_NEVER_SENT, light.name, 0.0, 1.0))
        } else {
            ConeDeviations.of(light, sent)
        }

    /** Whether [light] has a cone of which nothing was sent: it is one of the values that had to be given to see any light. */
    private fun isMadeUp(
        light: LightModel,
        sent: List<Double>,
    ): Boolean = light.cone?.let { ConeWords.of(it.cosInner, it.cosOuter, sent) == null } == true

    /** Spotlights that were given a colour and no cone. */
    private fun silent(study: ProgramStudy): List<Deviation> =
        study.silent
            .filter { light ->
                light.missing.any { it.components <= 2 }
            }.map { Deviation(Mistake.CONE_NEVER_SENT, it.slot.text, 0.0, 1.0) }

    private fun material(study: ProgramStudy): List<Deviation> {
        val roles = study.roles ?: return emptyList()
        val found = mutableListOf<Deviation>()

        fun add(
            mistake: Mistake,
            check: Check = mistake.check,
        ) {
            found += Deviation(mistake, "", 0.0, 1.0, check = check)
        }
        if (roles.isShared) add(Mistake.UNKNOWN, Check.MATERIAL)
        if (roles.diffuse == null && roles.specular != null) add(Mistake.DIFFUSE_MISSING)
        if (roles.specular == null && roles.untextured < 1e-3) add(Mistake.SPECULAR_MISSING)
        if (isSwapped(roles, study.files)) add(Mistake.MAPS_SWAPPED)
        val units = study.box.program.samplers.mapNotNull { study.box.values[it.name]?.firstOrNull() }
        if (units.size != units.distinct().size) add(Mistake.SAMPLER_UNIT)
        if (study.exponent < 1 || roles.powers.values.any { it < ENCODED }) add(Mistake.GAMMA_DIRECTION)
        return found
    }

    /** Whether the files that the samplers read, or else their own names, say that they have each other's work. */
    private fun isSwapped(
        roles: TextureRoles,
        files: Map<String, Set<String>>,
    ): Boolean {
        val diffuse = roles.diffuse ?: return false
        val specular = roles.specular ?: return false
        val names = listOf(diffuse, specular).map { files[it].orEmpty() }
        if (names.all { it.isNotEmpty() }) return names[0].any(::saysSpecular) && names[1].any(::saysDiffuse)
        return saysSpecular(diffuse) && saysDiffuse(specular)
    }

    private fun saysSpecular(name: String) = SPECULAR_NAME.containsMatchIn(name) && !DIFFUSE_NAME.containsMatchIn(name)

    private fun saysDiffuse(name: String) = DIFFUSE_NAME.containsMatchIn(name) && !SPECULAR_NAME.containsMatchIn(name)

    private fun emission(study: ProgramStudy): List<Deviation> =
        when (study.emission.form) {
            EmissionForm.TINTED -> emptyList()
            EmissionForm.UNTINTED -> listOf(Deviation(Mistake.EMISSION_COLOR_IGNORED, "", 0.0, 1.0))
            EmissionForm.MULTIPLIED -> listOf(Deviation(Mistake.EMISSION_MULTIPLIED, "", 0.0, 1.0))
            EmissionForm.MISSING -> listOf(Deviation(Mistake.EMISSION_MISSING, "", 0.0, 1.0))
        }

    private fun view(study: ProgramStudy): List<Deviation> {
        val scale = study.box.spaces.view?.scale() ?: return emptyList()
        return if (kotlin.math.abs(scale - 1) <
            1e-3
        ) {
            emptyList()
        } else {
            listOf(Deviation(Mistake.VIEW_SCALED, "", 0.0, kotlin.math.abs(scale - 1)))
        }
    }

    // A texture is taken as it is (1) or decoded (2.2); what makes it brighter encodes it once more.
    private const val ENCODED = 0.8
    private val DIFFUSE_NAME = Regex("diff|albedo|base", RegexOption.IGNORE_CASE)
    private val SPECULAR_NAME = Regex("spec|gloss|shin", RegexOption.IGNORE_CASE)
}

package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured

/** How far shading is from right, check by check. */
internal object StudyChecks {
    /** One entry for each check that shaders decide. */
    fun of(
        studies: Collection<ProgramStudy>,
        mistakes: List<Found>,
    ): List<Measured> {
        val lights = studies.flatMap { it.lights }.filter { it.placement != null }
        val spots = lights.filter { it.cone != null }
        return listOf(
            measured(Check.DIFFUSE, mistakes, lights.map { it.cosineError }, "clamped cosine between normal and light"),
            measured(Check.SPECULAR, mistakes, lights.mapNotNull { it.highlight?.fit?.error }, "power of a cosine with the exponent sent"),
            measured(
                Check.NORMALS,
                mistakes,
                lights.mapNotNull {
                    it.placement?.error
                },
                "angle between the light's directions and the light, in radians",
            ),
            measured(Check.INTERPOLATION, mistakes, lights.flatMap(::interpolation), "middle of a triangle against a vertex there"),
            measured(Check.MATERIAL, mistakes, studies.mapNotNull { it.roles?.let { 0.0 } }, "each texture in its own term"),
            measured(Check.CONE, mistakes, spots.mapNotNull { it.cone?.error }, "intensity over the angle to the axis"),
            measured(
                Check.CONE_SPECULAR,
                mistakes,
                spots.mapNotNull { it.highlight?.limits?.all },
                "highlight inside and outside of the cone",
            ),
            measured(Check.ATTENUATION_FORM, mistakes, lights.mapNotNull { it.attenuation?.error }, "1/(Kc + Kl d + Kq d^2)"),
            measured(Check.EMISSION, mistakes, studies.map { 0.0 }, "emission times its colour"),
            measured(
                Check.MORE_LIGHTS_SHADING,
                mistakes,
                if (lights.size >
                    2
                ) {
                    lights.map { it.cosineError }
                } else {
                    emptyList()
                },
                "${lights.size} lights",
            ),
            measured(Check.HALF_VECTOR, mistakes, lights.mapNotNull { it.highlight?.fit?.error }, "half vector of unit vectors"),
        )
    }

    /** The worst of [errors], or 1 and its mistake's fit where a mistake has been named: then the errors are those of the wrong hypothesis. */
    private fun measured(
        check: Check,
        mistakes: List<Found>,
        errors: List<Double>,
        what: String,
    ): Measured {
        val named = mistakes.filter { it.mistake.check == check }
        val worst = if (named.isNotEmpty()) named.maxOf { it.difference }.coerceAtMost(1.0) else errors.maxOrNull()?.coerceAtMost(1.0)
        val text = if (named.isEmpty()) what else named.joinToString("; ") { "${it.mistake.id} ${it.where}".trim() }
        return Measured(check, worst, text)
    }

    private fun interpolation(light: LightModel): List<Double> =
        listOfNotNull(light.diffuseInterpolation, light.specularInterpolation).flatMap { listOf(it.vectors, it.normals) }
}

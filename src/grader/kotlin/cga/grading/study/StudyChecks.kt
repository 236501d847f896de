package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake

/** How far shading is from right, check by check. */
internal object StudyChecks {
    /** One entry for each check that shaders decide. */
    fun of(
        studies: Collection<ProgramStudy>,
        mistakes: List<Found>,
        unnamed: List<Deviation>,
    ): List<Measured> {
        fun measured(
            check: Check,
            mistakes: List<Found>,
            errors: List<Double>,
            what: String,
        ) = measured(
            check,
            mistakes.filter { it.mistake.check == check && it.mistake != Mistake.UNKNOWN },
            unnamed.filter {
                it.check ==
                    check
            },
            errors,
            what,
        )

        val lights = studies.flatMap { it.shining }.filter { it.placement != null }
        val spots = lights.filter { it.cone != null }
        val highlights = lights.filterNot(LightDeviations::isLawless).ifEmpty { lights }.mapNotNull { it.highlight?.fit?.error }
        return listOf(
            measured(Check.DIFFUSE, mistakes, lights.map { it.cosineError }, "clamped cosine between normal and light"),
            measured(Check.SPECULAR, mistakes, highlights, "power of a cosine with the exponent sent"),
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
                // Whether it fades with the distance is judged by itself.
                spots.mapNotNull { spot -> spot.highlight?.limits?.let { minOf(it.all, it.coneOnly) } },
                "highlight inside and outside of the cone",
            ),
            measured(
                Check.ATTENUATION_FORM,
                mistakes,
                lights.filterNot(LightDeviations::isStrange).mapNotNull { it.attenuation?.error },
                "1/(Kc + Kl d + Kq d^2)",
            ),
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
            measured(Check.HALF_VECTOR, mistakes, highlights, "half vector of unit vectors"),
        )
    }

    /** The worst of [errors], or the difference of what is [named] or [unnamed]: then the errors are those of a wrong hypothesis. */
    private fun measured(
        check: Check,
        named: List<Found>,
        unnamed: List<Deviation>,
        errors: List<Double>,
        what: String,
    ): Measured {
        val differences = named.map { it.difference } + unnamed.map { it.difference }
        val worst = differences.ifEmpty { errors }.maxOrNull()?.coerceAtMost(1.0)
        val text = named.map { "${it.mistake.id} ${it.where}".trim() } + unnamed.map(::text).distinct()
        return Measured(check, worst, if (text.isEmpty()) what else text.joinToString("; "))
    }

    private fun text(unnamed: Deviation) =
        if (unnamed.why.isEmpty()) {
            "${unnamed.mistake.id} ${unnamed.light}".trim()
        } else {
            listOf(unnamed.light, unnamed.why).filter { it.isNotEmpty() }.joinToString(": ")
        }

    private fun interpolation(light: LightModel): List<Double> =
        listOfNotNull(light.diffuseInterpolation, light.specularInterpolation).flatMap { listOf(it.vectors, it.normals) }
}

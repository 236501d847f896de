package cga.grading.sheet4.shading

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.reading.CaptureReading
import cga.grading.reading.LightReading
import cga.grading.reading.Variant

/** What the shaders of a capture compute beside what the sheet asks for. */
internal class Shading(private val reading: CaptureReading) {
    /** Programs that nothing falls on draw something else beside those that have lights: a sky, sparks, a trail. */
    private val programs = reading.programs.keys.let { all -> all.filter { lights(it).isNotEmpty() }.ifEmpty { all } }
    private val lights: List<LightReading> = programs.flatMap(::lights)

    /** What is wrong, by number of the program. */
    val byProgram: Map<Int, List<Deviation>> =
        programs.groupBy { it.program }.mapValues { (_, variants) ->
            variants.flatMap { ProgramAxes(reading.programs.getValue(it), lights(it)).deviations() }
        }
    val deviations: List<Deviation> = byProgram.values.flatten()

    private fun lights(variant: Variant) = reading.lights[variant].orEmpty()

    /** Each mistake once, with the lights that have it. */
    val mistakes: List<Found> =
        deviations
            .groupBy { it.mistake to it.text }
            .values
            .map { same ->
                val where = same.map { it.light }.filter { it.isNotEmpty() }.distinct().joinToString(", ")
                Found(same[0].mistake, 0.0, same.maxOf { it.error }, where)
            }.distinctBy { it.mistake }

    /** How far each check that shaders decide is from right; without an error where nothing shows it. */
    val checks: List<Measured> = SHOWN.map { (check, isShown) ->
        measured(
            check,
            lights.any(isShown) || (lights.isNotEmpty() && check in ALWAYS),
        )
    }

    private fun measured(check: Check, isShown: Boolean): Measured {
        val own = deviations.filter { it.check == check }
        val text = own.joinToString("; ") { "${it.mistake.id} ${it.light} ${it.line?.line ?: ""} ${it.text}" }
        return Measured(check, own.maxOfOrNull { it.error } ?: if (isShown) 0.0 else null, text)
    }

    private companion object {
        val ALWAYS = setOf(Check.EMISSION, Check.MATERIAL)
        val SHOWN: List<Pair<Check, (LightReading) -> Boolean>> = listOf(
            Check.DIFFUSE to { it.diffuse.isNotEmpty() },
            Check.SPECULAR to { it.specular.isNotEmpty() },
            Check.NORMALS to { it.diffuse.isNotEmpty() },
            Check.INTERPOLATION to { it.diffuse.isNotEmpty() },
            Check.MATERIAL to { it.diffuse.isNotEmpty() },
            Check.CONE to { it.cone != null },
            Check.CONE_SPECULAR to { it.cone != null && it.specular.isNotEmpty() },
            Check.ATTENUATION_FORM to { it.fade != null },
            Check.EMISSION to { false },
            Check.MORE_LIGHTS_SHADING to { it.cone == null },
            Check.HALF_VECTOR to { it.specular.isNotEmpty() },
        )
    }
}

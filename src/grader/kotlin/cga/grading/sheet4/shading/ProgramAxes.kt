package cga.grading.sheet4.shading

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.reading.Emission
import cga.grading.reading.EmissionForm
import cga.grading.reading.Interpolation
import cga.grading.reading.LightReading
import cga.grading.reading.ProgramReading
import kotlin.math.abs

/** What a program does that concerns no single light: emission, textures, gamma, the scale of the view. */
internal class ProgramAxes(private val reading: ProgramReading, private val lights: List<LightReading>) {
    private val interpolation = Interpolation(reading)
    val emission = Emission.of(reading, lights)
    private val diffuse = lights.flatMap { it.diffuse }
    private val specular = lights.flatMap { it.specular }

    /** All that is wrong with the shading, of the lights and of the whole. */
    fun deviations(): List<Deviation> =
        lights.flatMap { LightAxes(reading, it, lights, interpolation).deviations() } + emission() + terms() + textures() + view() + gamma()

    private fun one(mistake: Mistake, check: Check = mistake.check, text: String = "", error: Double = 1.0) =
        listOf(Deviation(mistake, "", error, emission.line, check, text))

    private fun emission(): List<Deviation> =
        when (emission.form) {
            EmissionForm.TINTED -> emptyList()
            EmissionForm.UNTINTED -> one(Mistake.EMISSION_COLOR_IGNORED)
            EmissionForm.ADDED -> one(Mistake.EMISSION_COLOR_ADDED)
            EmissionForm.ON_EVERYTHING -> one(Mistake.COLOR_ON_EVERYTHING)
            EmissionForm.MULTIPLIED -> one(Mistake.EMISSION_MULTIPLIED)
            EmissionForm.PRODUCT -> one(Mistake.UNKNOWN, Check.EMISSION, "emission-product")
            EmissionForm.REPEATED -> one(Mistake.UNKNOWN, Check.EMISSION, "emission-repeated")
            EmissionForm.MISSING -> one(Mistake.EMISSION_MISSING)
        }

    private fun terms(): List<Deviation> =
        when {
            lights.isEmpty() -> emptyList()
            diffuse.isEmpty() -> one(Mistake.DIFFUSE_MISSING)
            specular.isEmpty() -> one(Mistake.SPECULAR_MISSING)
            else -> lights.filter { it.specular.isEmpty() && it.diffuse.isNotEmpty() }.map {
                Deviation(
                    Mistake.SPECULAR_MISSING,
                    it.name,
                    1.0,
                    null,
                )
            }
        }

    /** Each of the terms has a texture of its own, read as it is or decoded once. */
    private fun textures(): List<Deviation> {
        val own = diffuse.flatMap { it.textures }.map { it.sampler }.toSet()
        val isShared =
            specular.isNotEmpty() && specular.all { term -> term.textures.isNotEmpty() && term.textures.all { it.sampler in own } }
        return when {
            lights.isEmpty() || diffuse.isEmpty() || specular.isEmpty() -> emptyList()
            isShared -> one(Mistake.UNKNOWN, Check.MATERIAL, "one-texture-for-both-terms")
            specular.all { it.textures.isEmpty() } -> one(Mistake.UNKNOWN, Check.MATERIAL, "highlight-without-a-texture")
            reading.terms.flatMap { it.textures }.any { it.power > DECODED_TWICE } -> one(Mistake.UNKNOWN, Check.MATERIAL, "decoded-twice")
            else -> emptyList()
        }
    }

    private fun view(): List<Deviation> {
        val scale = reading.spaces.view?.let { Math.cbrt(abs(it.determinant3x3())) } ?: return emptyList()
        return if (abs(scale - 1) < 1e-3) emptyList() else one(Mistake.VIEW_SCALED, error = abs(scale - 1))
    }

    private fun gamma(): List<Deviation> {
        val powers = reading.terms.flatMap { it.textures }.map { it.power }
        if (reading.encoding.isPartial) return one(Mistake.UNKNOWN, Check.EMISSION, "added-after-the-encoding")
        return if (reading.encoding.power > 1 + 1e-6 || powers.any { it < 0.8 }) one(Mistake.GAMMA_DIRECTION) else emptyList()
    }

    private companion object {
        /** Halfway from one decoding to two. */
        const val DECODED_TWICE = 3.3
    }
}

package cga.grading.reading

/** What becomes of the emissive texture. */
internal enum class EmissionForm { TINTED, UNTINTED, ADDED, ON_EVERYTHING, MULTIPLIED, PRODUCT, REPEATED, MISSING }

/**
 * The part of the picture that no light has a part in.
 *
 * @property tint the colour of the emission, red, green and blue.
 * @property ambient the colour that the diffuse texture is multiplied with everywhere.
 * @property line where it is computed, null where it is not.
 */
internal class Emission(
    val form: EmissionForm,
    val sampler: String?,
    val tint: List<Node>?,
    val ambient: List<Node>?,
    val line: ShaderLine?,
) {
    companion object {
        fun of(reading: ProgramReading, lights: List<LightReading>): Emission {
            val common = LightFinder(reading).common
            val dark = reading.terms.filter { it.ways.isEmpty() && it.factors.none { f -> f is Factor.Unknown } }
            val lit = lights.flatMap { it.terms }
            val lightSamplers = (lights.flatMap { it.diffuse } + lights.flatMap { it.specular })
                .groupBy { term ->
                    term.textures.map { it.sampler }.toSet()
                }.entries
                .filter { it.key.size == 1 }
                .sortedByDescending { it.value.size }
                .take(2)
                .flatMap { it.key }
                .toSet()
            val glow = dark.filter { term -> term.textures.any { it.sampler !in lightSamplers } }
            val ambient = dark
                .find { term ->
                    term.textures.isNotEmpty() && term.textures.all { it.sampler in lightSamplers }
                }?.colors
                ?.firstOrNull()
            val flat = dark.filter { it.textures.isEmpty() && it.colors.isNotEmpty() }
            val term = glow.firstOrNull()
            val sampler = term?.textures?.find { it.sampler !in lightSamplers }?.sampler
            val tint = term?.colors?.firstOrNull() ?: flat.firstOrNull()?.colors?.firstOrNull()
            val isMultiplied =
                lit.any { it.textures.map { t -> t.sampler }.distinct().size > 1 } ||
                    lit.any { it.textures.any { t -> t.sampler !in lightSamplers } }
            val isInAll = lit.isNotEmpty() && lit.all { it.textures.map { t -> t.sampler }.distinct().size > 1 }
            val form = when {
                isInAll -> EmissionForm.MULTIPLIED
                term == null -> if (isMultiplied) EmissionForm.MULTIPLIED else EmissionForm.MISSING
                common.isNotEmpty() && term.colors.any { it[0].key in common } -> EmissionForm.ON_EVERYTHING
                term.textures.map { it.sampler }.distinct().size > 1 -> EmissionForm.PRODUCT
                term.sign > 1.5 -> EmissionForm.REPEATED
                term.colors.isNotEmpty() -> EmissionForm.TINTED
                flat.isNotEmpty() -> EmissionForm.ADDED
                else -> EmissionForm.UNTINTED
            }
            return Emission(form, sampler, tint, ambient, term?.colors?.firstOrNull()?.get(0)?.line)
        }
    }
}

package cga.grading.study

import org.joml.Vector3d

/**
 * What a program shows before anything is known of it: its colours, and the conditions under which they show.
 *
 * @param box with the gamma undone, and where nothing would shine with values for uniforms that were never sent.
 * @param search that finds the points where the lights of [colors] shine.
 * @param deadly uniforms that are 0 in the draw and leave no number of the picture, whatever else is sent: something is divided by them.
 * @param afterGamma the sampler of a texture that is added when the lights have been encoded already; null where there is none.
 */
internal class FirstLook private constructor(
    val box: BlackBox,
    val colors: ColorSlots,
    val search: LightSearch,
    val deadly: Set<String> = emptySet(),
    val afterGamma: String? = null,
) {
    companion object {
        /** Looks at [box] on and around [surface], points in view space. */
        fun of(
            box: BlackBox,
            surface: List<Vector3d>,
        ): FirstLook {
            val search = LightSearch(box, surface)
            val few = search.samples(LightSearch.FEW_DIRECTIONS)
            val many = search.samples(LightSearch.MANY_DIRECTIONS)
            val plain = FirstLook(box, ColorSlots.of(box, few, many), LightSearch(box, surface))
            val isDead = isDead(box, few)
            val isPlain = plain.colors.lights.isNotEmpty() && !isDead
            // Beside something bright a little light is as good as not encoded.
            if (isPlain && plain.colors.bent(box, few).isEmpty()) return wider(plain, surface)
            for (exponent in EXPONENTS) {
                val decoded = box.decodedBy(exponent)
                val colors = ColorSlots.of(decoded, few, many)
                val least = if (isPlain) plain.colors.lights.size else 0
                if (colors.lights.size > least) return FirstLook(decoded, colors, LightSearch(decoded, surface))
            }
            if (isPlain) return wider(plain, surface)
            if (!isDead) besideGamma(box, surface, few, many)?.let { return it }
            val clamped = ColorSlots.of(box, few, many, isSumClamped = true)
            if (clamped.lights.isNotEmpty() && !isDead) return FirstLook(box, clamped, search)
            // One light that divides by what was never sent can make all of the picture NaN.
            val zeros = SilentLights.zeros(box)
            val awake = SilentLights.awake(box, zeros)
            val colors = ColorSlots.of(awake, few, many)
            if (colors.lights.isEmpty()) return wider(plain, surface)
            return FirstLook(awake, colors, LightSearch(awake, surface), deadly(box, awake, zeros, few))
        }

        /** A look at lights that are encoded, with a texture that is added to them afterwards; null where that is not so. */
        private fun besideGamma(
            box: BlackBox,
            surface: List<Vector3d>,
            few: List<Sample>,
            many: List<Sample>,
        ): FirstLook? {
            val samplers = box.program.samplers.map { it.name }
            if (samplers.size < 2) return null
            val decoded = box.decodedBy(USUAL)
            for (sampler in samplers) {
                val colors = ColorSlots.of(decoded, few, many, blank = setOf(sampler))
                if (colors.lights.isEmpty()) continue
                val tints = ColorSlots.of(box, few, many, blank = samplers.toSet() - sampler).flats
                return FirstLook(decoded, colors.withFlats(tints), LightSearch(decoded, surface), afterGamma = sampler)
            }
            return null
        }

        /** [plain], or where colours are sent that show nowhere a look at the places that wrong matrices would bring lights to. */
        private fun wider(
            plain: FirstLook,
            surface: List<Vector3d>,
        ): FirstLook {
            val box = plain.box
            val silent = plain.colors.silent.filter { slot ->
                slot.name !in box.program.constants && box.values[slot.name]?.any { it != 0f } == true
            }
            if (silent.isEmpty()) return plain
            val search = LightSearch(box, surface, isWide = true)
            val few = search.samples(LightSearch.FEW_DIRECTIONS)
            val many = search.samples(LightSearch.MANY_DIRECTIONS)
            // A look at everything takes long.
            if (silent.all { ColorSlots.isSilent(box, few, it) && ColorSlots.isSilent(box, many, it) }) return plain
            val colors = ColorSlots.of(box, few, many)
            if (colors.lights.size <= plain.colors.lights.size) return plain
            return FirstLook(box, colors, LightSearch(box, surface, isWide = true))
        }

        private fun deadly(
            box: BlackBox,
            awake: BlackBox,
            zeros: List<ActiveUniform>,
            samples: List<Sample>,
        ): Set<String> {
            if (!isDead(box, samples)) return emptySet()
            return zeros.filter { isDead(awake.withValues(mapOf(it.name to FloatArray(it.components))), samples) }.map { it.name }.toSet()
        }

        /** Whether most of what [box] shows is no number. */
        private fun isDead(
            box: BlackBox,
            samples: List<Sample>,
        ) = box.shade(samples, Setting()).let { all -> all.count { it.isFinite() } < all.size / 2 }

        private const val USUAL = 2.2
        private val EXPONENTS = listOf(USUAL, 1 / USUAL, 2.0, 0.5, 1.8, 2.4)
    }
}

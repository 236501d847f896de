package cga.grading.study

import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min

/**
 * The uniforms in which the picture is affine, channel by channel.
 *
 * @param lights those whose effect depends on the surface, each on its own.
 * @param flats those whose effect is the same everywhere: a tint of the emission, ambient light.
 * @param silent vectors without any effect.
 * @param factors those that multiply lights: colours of the material.
 * @param isSumClamped whether it is affine in them only where no light takes away what another brings.
 * @param suns those of the lights that are the same everywhere ([Suns]).
 */
internal class ColorSlots(
    val lights: List<ActiveUniform>,
    val flats: List<ActiveUniform>,
    val factors: List<ActiveUniform>,
    val silent: List<ActiveUniform>,
    val isSumClamped: Boolean = false,
    val suns: Set<ActiveUniform> = emptySet(),
) {
    /** The lights that have a place. */
    val lamps: List<ActiveUniform> get() = lights - suns

    /** These with some of the lights found to be [suns]. */
    fun withSuns(suns: Set<ActiveUniform>): ColorSlots = ColorSlots(lights, flats, factors, silent, isSumClamped, suns)

    /** These with [more] flats. */
    fun withFlats(more: List<ActiveUniform>): ColorSlots =
        ColorSlots(lights, (flats + more).distinct(), factors, silent - more.toSet(), isSumClamped, suns)

    /** Those vectors of [box] that none of these are, and that brighten the [samples] all the same: colours, but in no proportion. */
    fun bent(box: BlackBox, samples: List<Sample>): List<ActiveUniform> =
        (box.program.uniforms.filter { !it.isSampler && it.components in 3..4 } - (lights + flats + factors + silent).toSet())
            .filter { brightens(box, samples, it) }

    companion object {
        /** Textures are this dark while looking, so that a colour clamped at 1 by the shader stays below. */
        const val DARK = 1.0 / 64

        /**
         * Sorts the vector uniforms of [box] by what they do to the samples [first], and those that do nothing there to [more]. Where
         * [isSumClamped], a colour may do something else to less than half of them. The textures of the samplers [blank] are black.
         */
        fun of(
            box: BlackBox,
            first: List<Sample>,
            more: List<Sample>,
            isSumClamped: Boolean = false,
            blank: Set<String> = emptySet(),
        ): ColorSlots {
            val odd = if (isSumClamped) 0.5 else 0.0
            val base = dim(box, blank)
            val looks = box.program.uniforms.filter { !it.isSampler && it.type in VECTORS }.map { look(box, first, base, it, odd) }
            val all = looks.map { if (it.isSilent) look(box, more, base, it.slot, odd) else it }
            val samples = if (all.indices.any { all[it].isColor && looks[it].isSilent }) first + more else first
            val found = all.filter { it.isColor }
            val flats = found.filter { it.isFlat }.map { it.slot }
            val uneven = found.filter { !it.isFlat }.map { it.slot }
            val lit = base.withColors(uneven, 1.0)
            val dark = lit.withColors(uneven, 0.0)
            val (alone, mixed) = apart(box, samples, uneven, lit)
            // Of colours that multiply each other the one that multiplies most of them belongs to the material.
            val partners = mixed.associateWith { slot -> mixed.filter { it != slot && multiply(box, samples, dark, slot, it) } }
            // What shows without any light colours the emission, too.
            val unlit = box.shade(samples, dark).largest()
            val glowing = mixed.filter { box.shade(samples, dark.withColors(listOf(it), 1.0)).largest() > unlit }
            val factors = partners.filter { (slot, others) -> others.any { isMoreOfAFactor(slot, it, partners, glowing) } }.keys
            return ColorSlots(alone + (mixed - factors), flats, factors.toList(), all.filter { it.isSilent }.map { it.slot }, isSumClamped)
        }

        /** Whether [slot] is a light's colour as far as [samples] show. */
        fun isLight(
            box: BlackBox,
            samples: List<Sample>,
            slot: ActiveUniform,
            base: Setting = dim(box),
        ): Boolean = look(box, samples, base, slot).let { it.isColor && !it.isFlat }

        /** Whether [slot] changes nothing of [samples]. */
        fun isSilent(
            box: BlackBox,
            samples: List<Sample>,
            slot: ActiveUniform,
        ): Boolean = look(box, samples, dim(box), slot).isSilent

        /** Whether the picture is nowhere darker the more of [slot] there is, and brighter somewhere: a colour, however its light is added. */
        fun brightens(
            box: BlackBox,
            samples: List<Sample>,
            slot: ActiveUniform,
        ): Boolean {
            val (none, some, more) = listOf(0.0, 1.0, 2.0).map { level ->
                box.shade(samples, dim(box).withColor(slot, level * LEVELS[0], level * LEVELS[1], level * LEVELS[2]))
            }

            fun isDarker(a: Double, b: Double) = !(a <= b + AFFINE * abs(b) + TINY)
            if (none.indices.any { isDarker(none[it], some[it]) || isDarker(some[it], more[it]) }) return false
            return none.indices.any { isDarker(some[it], none[it]) && isDarker(more[it], some[it]) }
        }

        /** All textures of [box] [DARK], those of the samplers [blank] black. */
        private fun dim(
            box: BlackBox,
            blank: Set<String> = emptySet(),
        ) = Setting().withTexels(box.program.samplers.associate { it.name to if (it.name in blank) 0.0 else DARK })

        /** Whether [a] does the same with [b] at 0 as with [b] at 1, all else as [setting] has it. */
        fun areApart(
            box: BlackBox,
            samples: List<Sample>,
            setting: Setting,
            a: ActiveUniform,
            b: ActiveUniform,
        ): Boolean {
            val on = setting.withColors(listOf(a, b), 1.0)
            return a in apart(box, samples, listOf(a, b), on).first
        }

        private fun isMoreOfAFactor(
            slot: ActiveUniform,
            other: ActiveUniform,
            partners: Map<ActiveUniform, List<ActiveUniform>>,
            glowing: List<ActiveUniform>,
        ): Boolean {
            val mine = partners.getValue(slot).size
            val theirs = partners.getValue(other).size
            // A colour written into the shader that multiplies one that is sent is no light's own, however many there are.
            val isWritten = slot.name.startsWith("cga_") && !other.name.startsWith("cga_")
            val otherIsWritten = other.name.startsWith("cga_") && !slot.name.startsWith("cga_")
            if (isWritten || otherIsWritten) return isWritten
            if (mine == theirs && (slot in glowing) != (other in glowing)) return slot in glowing
            return mine > theirs ||
                (mine == theirs && MATERIAL_NAME.containsMatchIn(slot.text) && !MATERIAL_NAME.containsMatchIn(other.text))
        }

        private class Look(
            val slot: ActiveUniform,
            val isSilent: Boolean = false,
            val isColor: Boolean = false,
            val isFlat: Boolean = false,
        )

        /** @param odd share of what [slot] changes that it may change otherwise than a colour. */
        private fun look(
            box: BlackBox,
            samples: List<Sample>,
            base: Setting,
            slot: ActiveUniform,
            odd: Double = 0.0,
        ): Look {
            val none = box.shade(samples, base.withColor(slot, 0.0, 0.0, 0.0))
            val once = box.shade(samples, base.withColor(slot, LEVELS[0], LEVELS[1], LEVELS[2]))
            val effect = DoubleArray(none.size) { once[it] - none[it] }
            // Each sample is judged by what it shows itself: highlights may be 1e18 times brighter than all else.
            val seen = none.indices.filter {
                abs(effect[it]) > noise(box) * NOTHING * max(abs(none[it]), abs(once[it])) &&
                    effect[it].isFinite()
            }
            if (seen.isEmpty()) return Look(slot, isSilent = true)
            val twice = box.shade(samples, base.withColor(slot, 2 * LEVELS[0], 2 * LEVELS[1], 2 * LEVELS[2]))
            // A draw may have a colour on everything that hides red.
            val channel = (0..2).maxBy { c -> seen.count { it % 3 == c } }
            val single = DoubleArray(3) { if (it == channel) LEVELS[it] else 0.0 }
            val alone = box.shade(samples, base.withColor(slot, single[0], single[1], single[2]))

            fun allowed(i: Int) = AFFINE * abs(effect[i]) + noise(box) * FLOAT * (abs(none[i]) + abs(twice[i])) + TINY
            val finite = none.indices.filter { effect[it].isFinite() }
            val most = (odd * seen.size).toInt()
            if (finite.count { abs(twice[it] - none[it] - 2 * effect[it]) > allowed(it) } > most) return Look(slot)
            val isMixed = finite.count { abs(alone[it] - none[it] - if (it % 3 == channel) effect[it] else 0.0) > allowed(it) } > most
            if (isMixed) return Look(slot)
            val effects = seen.filter { it % 3 == channel }.map { effect[it] }.sorted()
            val typical = effects[effects.size / 2]
            val isFlat = finite.all { it % 3 != channel || abs(effect[it] - typical) <= allowed(it) + AFFINE * abs(typical) }
            return Look(slot, isColor = true, isFlat = isFlat)
        }

        /** Those of [slots], all of them [lit], that do the same with all others at 0; and those that do not. */
        private fun apart(
            box: BlackBox,
            samples: List<Sample>,
            slots: List<ActiveUniform>,
            lit: Setting,
        ): Pair<List<ActiveUniform>, List<ActiveUniform>> {
            val with = box.shade(samples, lit)
            val dark = lit.withColors(slots, 0.0)
            val aloneWithout = box.shade(samples, dark)
            return slots.partition { slot ->
                val without = box.shade(samples, lit.withColors(listOf(slot), 0.0))
                val aloneWith = box.shade(samples, dark.withColors(listOf(slot), 1.0))
                with.indices.all {
                    val effect = with[it] - without[it]
                    !(abs(effect - (aloneWith[it] - aloneWithout[it])) > AFFINE * abs(effect) + noise(box) * FLOAT * abs(with[it]) + TINY)
                }
            }
        }

        /** Whether [a] and [b] are factors of one product: together they add what one of them by itself adds nothing of. */
        private fun multiply(
            box: BlackBox,
            samples: List<Sample>,
            dark: Setting,
            a: ActiveUniform,
            b: ActiveUniform,
        ): Boolean {
            fun shown(vararg slots: ActiveUniform) = box.shade(samples, dark.withColors(slots.toList(), 1.0))
            val none = shown()
            val onlyA = shown(a)
            val onlyB = shown(b)
            val both = shown(a, b)
            // What colours the emission too adds that by itself; its share of the product is what both show beyond.
            return both.indices.any { i ->
                val product = both[i] - onlyA[i] - onlyB[i] + none[i]
                val alone = min(abs(onlyA[i] - none[i]), abs(onlyB[i] - none[i]))
                product > PRODUCT * alone && product > AFFINE * abs(both[i]) + noise(box) * FLOAT * abs(both[i]) + TINY
            }
        }

        /** How much more is rounded where a gamma is undone: two powers, the driver's good to some 1e-5. */
        private fun noise(box: BlackBox): Double = if (box.exponent == 1.0) 1.0 else 30.0

        private val VECTORS = setOf(org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3, org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4)
        private val MATERIAL_NAME = Regex("mat|diff|spec|albedo|surface", RegexOption.IGNORE_CASE)

        /** Of red, green and blue while looking: no two alike, and in floats exact. */
        private val LEVELS = listOf(0.5, 0.75, 0.625)

        // An effect below a few roundings of what is there is none.
        private const val NOTHING = 2e-6
        private const val AFFINE = 2e-4
        private const val FLOAT = 1e-6
        private const val TINY = 1e-12

        /** How much larger a product is than what rounding leaves of a factor alone. */
        private const val PRODUCT = 100
    }
}

/** The largest finite number of these, without its sign. */
internal fun DoubleArray.largest(vararg more: DoubleArray): Double {
    var result = 0.0
    for (array in arrayOf(this, *more)) for (value in array) if (value.isFinite()) result = max(result, abs(value))
    return result
}

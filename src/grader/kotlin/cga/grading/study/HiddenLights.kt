package cga.grading.study

import kotlin.math.abs

/** Lights whose colour is no uniform and no constant: they shine when all that was found is black. */
internal object HiddenLights {
    /** Whether anything but [colors] lights the [samples]: what glows is the same for all of them. */
    fun areThere(
        box: BlackBox,
        colors: ColorSlots,
        samples: List<Sample>,
    ): Boolean = areThere(box, samples, dark(box, colors))

    private fun areThere(
        box: BlackBox,
        samples: List<Sample>,
        dark: Setting,
    ): Boolean {
        val shades = box.shade(samples, dark)
        val red = samples.indices.map { shades[3 * it] }.filter { it.isFinite() }
        if (red.isEmpty()) return false
        return red.max() - red.min() > UNEVEN * maxOf(abs(red.max()), abs(red.min()), ColorSlots.DARK)
    }

    /** [colors] with those of the lifted vectors of a deep program that are the colour of one hidden light each. */
    fun added(
        box: BlackBox,
        colors: ColorSlots,
        samples: List<Sample>,
    ): ColorSlots {
        val dark = dark(box, colors)
        // What colours only one term of lights is the colour of a material.
        val terms = box.program.samplers.map { Setting(dark.values).withTexels(mapOf(it.name to ColorSlots.DARK)) }
        val lit = terms.filter { areThere(box, samples, it) }
        val whole = box.program.deep.filter { slot -> lit.all { effect(box, samples, it, slot) > 0 } }
        val effects = whole.associateWith { effect(box, samples, dark, it) }
        val found = mutableListOf<ActiveUniform>()
        // What colours several lights together shows more than each of them.
        for (slot in effects.filterValues { it > 0 }.keys.sortedBy { effects.getValue(it) }) {
            val isOfAnother = colors.lights.any { !ColorSlots.areApart(box, samples, dark.withColors(listOf(it), 1.0), slot, it) }
            if (isOfAnother || !ColorSlots.isLight(box, samples, slot, dark)) continue
            if (found.all { ColorSlots.areApart(box, samples, dark, slot, it) }) found += slot
        }
        return ColorSlots(colors.lights + found, colors.flats, colors.factors, colors.silent)
    }

    /** The channel in which the colour [slot] shows most: its others may be black just now. */
    fun channel(
        box: BlackBox,
        slot: ActiveUniform,
        samples: List<Sample>,
    ): Int {
        val base = Setting().withTexels(box.program.samplers.associate { it.name to ColorSlots.DARK })
        val with = box.shade(samples, base)
        val without = box.shade(samples, base.withColor(slot, 0.0, 0.0, 0.0))
        val effect = with.indices.map { i -> abs(with[i] - without[i]).let { if (it.isFinite()) it else 0.0 } }
        return (0..2).maxBy { c -> samples.indices.maxOf { effect[3 * it + c] } }
    }

    private fun effect(
        box: BlackBox,
        samples: List<Sample>,
        dark: Setting,
        slot: ActiveUniform,
    ): Double {
        val with = box.shade(samples, dark)
        val without = box.shade(samples, dark.withColor(slot, 0.0, 0.0, 0.0))
        return with.indices.sumOf { i -> abs(with[i] - without[i]).let { if (it.isFinite()) it else 0.0 } }
    }

    private fun dark(
        box: BlackBox,
        colors: ColorSlots,
    ) = Setting().withTexels(box.program.samplers.associate { it.name to ColorSlots.DARK }).withColors(colors.lights + colors.flats, 0.0)

    private const val UNEVEN = 1e-3
}

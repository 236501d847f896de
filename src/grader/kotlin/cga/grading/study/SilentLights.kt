package cga.grading.study

import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4
import kotlin.math.abs

/**
 * A light that shines on nothing as it was drawn, and would if other uniforms were not 0.
 *
 * @param slot its colour.
 * @param missing those of the uniforms at 0 that it would look different without.
 * @param hasCone whether it would be limited to a cone.
 */
internal class SilentLight(
    val slot: ActiveUniform,
    val missing: List<ActiveUniform>,
    val hasCone: Boolean,
)

/** Wakes up lights whose parameters were never sent: a uniform that is all 0 gets a value that a light could have. */
internal object SilentLights {
    /** The silent lights of [box] among its [colors] without any effect; [surface] are points on what is drawn. */
    fun of(
        box: BlackBox,
        colors: ColorSlots,
        surface: List<Vector3d>,
        roles: TextureRoles?,
    ): List<SilentLight> {
        val zeros = zeros(box)
        val candidates = colors.silent.filter { slot ->
            slot.name !in box.program.constants &&
                box.values[slot.name].let { it != null && it.any { part -> part != 0f } }
        }
        if (zeros.isEmpty() || candidates.isEmpty()) return emptyList()
        val awake = awake(box, zeros)
        val samples = LightSearch(awake, surface).samples(LightSearch.MANY_DIRECTIONS)
        return candidates.filter { ColorSlots.isLight(awake, samples, it) }.map { slot ->
            val all = ColorSlots(colors.lights + slot, colors.flats, colors.factors, colors.silent - slot)
            val model = roles?.let { LightStudy(LightSearch(awake, surface), it).of(LightProbe(awake, slot, all)) }
            SilentLight(slot, zeros.filter { matters(awake, it, samples, slot) }, model?.cone != null)
        }
    }

    /** Whether the light with the colour [slot] looks different with [zero] at 0 again. */
    private fun matters(
        awake: BlackBox,
        zero: ActiveUniform,
        samples: List<Sample>,
        slot: ActiveUniform,
    ): Boolean {
        fun shown(box: BlackBox): DoubleArray {
            val base = Setting().withTexels(box.program.samplers.associate { it.name to ColorSlots.DARK })
            val with = box.shade(samples, base.withColors(listOf(slot), 1.0))
            val without = box.shade(samples, base.withColors(listOf(slot), 0.0))
            return DoubleArray(with.size) { with[it] - without[it] }
        }
        val before = shown(awake)
        val after = shown(awake.withValues(mapOf(zero.name to FloatArray(zero.components))))
        return before.indices.any { !(abs(before[it] - after[it]) <= 1e-3 * abs(before[it]) + 1e-7) }
    }

    /** Number uniforms of [box] that are all 0. */
    fun zeros(box: BlackBox): List<ActiveUniform> =
        box.program.uniforms.filter { u ->
            u.type in NUMBERS && u.name !in box.program.constants &&
                box.values[u.name].let { it == null || it.all { part -> part == 0f } }
        }

    /** [box] with values in the place of [zeros]. */
    fun awake(
        box: BlackBox,
        zeros: List<ActiveUniform>,
    ): BlackBox {
        var scalars = 0
        return box.withValues(
            zeros.associate { zero ->
                zero.name to
                    when (zero.components) {
                        1 -> floatArrayOf(if (scalars++ % 2 == 0) 0.3f else 0.9f)
                        2 -> floatArrayOf(0.3f, 0.9f)
                        else -> floatArrayOf(0.1f, -0.4f, -0.9f, 1f).copyOf(zero.components)
                    }
            },
        )
    }

    private val NUMBERS = setOf(GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4)
}

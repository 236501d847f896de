package cga.grading.study

import org.joml.Vector3d
import kotlin.math.abs

/** What the shaders do with the emission texture. */
internal enum class EmissionForm {
    TINTED,

    /** The colour is a factor of the lights as well. */
    ALL_TINTED,

    /** The colour is added to the texture. */
    ADDED,
    UNTINTED,

    /** The texture is multiplied with another one. */
    PRODUCT,

    /** The texture is multiplied with the light: all of the light, or a share of it beside the other textures'. */
    MULTIPLIED,
    MISSING,
}

/**
 * The emission of a program.
 *
 * @param tint the uniform that colours it, null where none does; a constant of the shader may be one.
 * @param ambient the colour that lights the diffuse texture everywhere, if it is a uniform.
 * @param strength how much of the texture shows under a white colour: 1 where it is added once.
 */
internal class EmissionStudy(
    val form: EmissionForm,
    val tint: ActiveUniform?,
    val ambient: ActiveUniform?,
    val strength: Double = 1.0,
) {
    /** Whether the texture is added as often as something is done for each of [lights] lights, or of the [points] among them. */
    fun isForEach(
        lights: Int,
        points: Int,
    ): Boolean = listOf(lights, points, lights + 1, points + 1).any { it > 1 && abs(strength / it - 1) < WHOLE }

    companion object {
        fun of(
            box: BlackBox,
            colors: ColorSlots,
            roles: TextureRoles?,
        ): EmissionStudy {
            val candidates = colors.flats + colors.factors
            val point = listOf(Sample(Vector3d(0.3, 0.2, -4.0), Directions.AXES[2]))
            val dark = Setting().withColors(colors.lights, 0.0).withColors(candidates, 1.0)

            fun shown(
                name: String?,
                changed: Setting,
            ): Double {
                if (name == null) return 0.0
                return abs(box.shade(point, changed.withTexels(mapOf(name to 1.0)))[0] - box.shade(point, changed)[0])
            }
            // Without any light to tell the textures apart by, what glows is the emission.
            val sampler = roles?.emission ?: box.program.samplers.map { it.name }.takeIf { roles == null }?.maxByOrNull { shown(it, dark) }
            val ambient = candidates.firstOrNull {
                shown(roles?.diffuse, dark) >
                    shown(roles?.diffuse, dark.withColors(listOf(it), 0.0)) + 1e-4
            }
            if (roles != null && (roles.multiplied || roles.inLights)) return EmissionStudy(EmissionForm.MULTIPLIED, null, ambient)
            val shown = shown(sampler, dark)
            if (!(shown > 1e-4)) {
                val product = product(box, point, dark)
                if (product == null) {
                    val form = if (isLit(box, colors, roles)) EmissionForm.MULTIPLIED else EmissionForm.MISSING
                    return EmissionStudy(form, null, ambient)
                }
                val tint = candidates.firstOrNull { product(box, point, dark.withColors(listOf(it), 0.0)) == null }
                return EmissionStudy(EmissionForm.PRODUCT, tint, ambient, product)
            }
            val tint = candidates.firstOrNull { shown(sampler, dark.withColors(listOf(it), 0.0)) < 1e-4 * shown }
            val isCommon = tint in colors.factors && tint?.name !in box.program.constants
            val added = if (tint == null) added(box, point, dark, colors.flats) else null
            val form =
                when {
                    isCommon -> EmissionForm.ALL_TINTED
                    tint != null -> EmissionForm.TINTED
                    added != null -> EmissionForm.ADDED
                    else -> EmissionForm.UNTINTED
                }
            return EmissionStudy(form, tint ?: added, ambient, shown)
        }

        /** Whether a texture that is neither the diffuse nor the specular one shows by light. */
        private fun isLit(
            box: BlackBox,
            colors: ColorSlots,
            roles: TextureRoles?,
        ): Boolean {
            if (roles?.diffuse == null) return false
            val others = box.program.samplers.map { it.name } - setOfNotNull(roles.diffuse, roles.specular)
            val around = Directions.AXES.map { Sample(Vector3d(0.3, 0.2, -4.0), it) }
            val bright = Setting().withColors(colors.lights + colors.flats + colors.factors, 1.0)
            val unlit = box.shade(around, bright)
            return others.any { name ->
                val shown = box.shade(around, bright.withTexels(mapOf(name to 1.0)))
                shown.indices.any { shown[it] - unlit[it] > 1e-4 }
            }
        }

        /** What shows of two textures together and of none by itself; null where nothing does. */
        private fun product(
            box: BlackBox,
            point: List<Sample>,
            dark: Setting,
        ): Double? {
            fun shown(names: List<String>) = abs(box.shade(point, dark.withTexels(names.associateWith { 1.0 }))[0])
            val names = box.program.samplers.map { it.name }
            val alone = names.maxOfOrNull { shown(listOf(it)) } ?: return null
            val pairs = names.flatMap { a -> names.filter { it > a }.map { b -> shown(listOf(a, b)) } }
            return pairs.maxOrNull()?.minus(alone)?.takeIf { it > 1e-4 }
        }

        /** Relative: floats are a hundred times as exact. */
        private const val WHOLE = 1e-3

        /** The uniform among [flats] that shows where all textures are black. */
        private fun added(
            box: BlackBox,
            point: List<Sample>,
            dark: Setting,
            flats: List<ActiveUniform>,
        ): ActiveUniform? {
            val all = box.shade(point, dark)[0]
            return flats
                .filter { it.name !in box.program.constants }
                .firstOrNull { abs(all - box.shade(point, dark.withColors(listOf(it), 0.0))[0]) > 1e-4 }
        }
    }
}

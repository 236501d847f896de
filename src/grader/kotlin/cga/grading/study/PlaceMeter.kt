package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Measures where a light is, draw by draw, where no uniform is its place: it may be a matrix times a point that the shader knows, or the
 * sum of two.
 *
 * @param texels that leave only its diffuse term.
 */
internal class PlaceMeter private constructor(
    private val study: ProgramStudy,
    private val slot: ActiveUniform,
    private val texels: Map<String, Double>,
) {
    /** What is the same for the same light: most draws of a frame tell of the same one. */
    private val known = HashMap<Any, Vector3d?>()

    /** The place where uniforms are [values], in view space; null where its directions do not meet in a point. */
    fun place(
        values: Map<String, FloatArray>,
        spaces: Spaces,
    ): Vector3dc? {
        val own = study.formula.product.toSet() + listOfNotNull(study.emission.tint?.name)
        val key = listOf(spaces.view, (values - own).mapValues { it.value.toList() })
        return known.getOrPut(key) { measured(values, spaces) }
    }

    private fun measured(
        values: Map<String, FloatArray>,
        spaces: Spaces,
    ): Vector3d? {
        val probe = LightProbe(study.box.drawn(spaces, values), slot, study.colors)
        val search = LightSearch(probe.box, study.surface)
        val lit = search.litPoints(probe, texels)
        return search.place(probe, lit, texels)?.takeIf { it.isConsistent && it.error < Placement.ACCEPTED }?.view
    }

    companion object {
        /** That of [light]; null where it cannot be told by its diffuse term. */
        fun of(
            light: LightModel,
            study: ProgramStudy,
        ): PlaceMeter? {
            val roles = study.roles?.takeIf { it.diffuse != null && it.peak == Peak.DIFFUSE } ?: return null
            val placement = light.placement?.takeIf { it.isConsistent && !it.isFlipped } ?: return null
            if (light.otherDirection || placement.error > Placement.ACCEPTED) return null
            return PlaceMeter(study, light.probe.slot, roles.onlyDiffuse)
        }
    }
}

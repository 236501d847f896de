package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Measures where a spotlight points, draw by draw, where no uniform is its direction: it may be in a matrix, in angles, in the point that
 * it is aimed at.
 *
 * @param path that its normals take.
 * @param texels that leave only its diffuse term.
 */
internal class AxisMeter private constructor(
    private val study: ProgramStudy,
    private val slot: ActiveUniform,
    private val path: NormalPath,
    private val texels: Map<String, Double>,
    private val unclamped: Boolean,
) {
    /** What is the same for the same light: most draws of a frame tell of the same one. */
    private val known = HashMap<Any, Vector3d?>()

    /** The direction where uniforms are [values], of a light at [position], in view space; null where no cone is seen. */
    fun axis(
        values: Map<String, FloatArray>,
        spaces: Spaces,
        position: Vector3dc,
    ): Vector3d? {
        val own = study.formula.product.toSet() + listOfNotNull(study.emission.tint?.name)
        val key = listOf(position, spaces.view, (values - own).mapValues { it.value.toList() })
        return known.getOrPut(key) { measured(values, spaces, position) }?.let { Vector3d(it) }
    }

    private fun measured(
        values: Map<String, FloatArray>,
        spaces: Spaces,
        position: Vector3dc,
    ): Vector3d? {
        val probe = LightProbe(study.box.drawn(spaces, values), slot, study.colors)
        val amplitudes = Amplitudes(probe, Placement.inView(spaces, position, path), texels, unclamped)
        return ConeFit.of(amplitudes, emptyList(), emptyList())?.takeIf { it.residual < SOUND }?.axis?.let { Vector3d(it) }
    }

    companion object {
        /** That of [light]; null where it cannot be told by its diffuse term. */
        fun of(
            light: LightModel,
            study: ProgramStudy,
        ): AxisMeter? {
            val roles = study.roles?.takeIf { it.diffuse != null && it.peak == Peak.DIFFUSE } ?: return null
            val placement = light.placement?.takeIf { (it.isConsistent || it.space == Space.VIEW) && !it.isFlipped } ?: return null
            if (light.cone == null || light.otherDirection || placement.error > Placement.ACCEPTED) return null
            val path = if (placement.space == Space.VIEW) placement.path else NormalPath.VIEW
            return AxisMeter(study, light.probe.slot, path, roles.onlyDiffuse, light.unclamped)
        }

        private const val SOUND = 1e-2
    }
}

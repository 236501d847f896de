package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Measures the colour of a light that no uniform tells, draw by draw.
 *
 * @param texels that leave only its diffuse term.
 */
internal class ColorMeter(
    private val study: ProgramStudy,
    private val slot: ActiveUniform,
    private val texels: Map<String, Double>,
) {
    /** The colour where uniforms are [values], of a light at [position] with the law [k] that shines along [axis] (view space). */
    fun color(
        values: Map<String, FloatArray>,
        spaces: Spaces,
        position: Vector3dc,
        axis: Vector3dc,
        k: Vector3dc,
    ): Vector3d {
        val sample = Sample(Vector3d(position).add(axis), Vector3d(axis).negate())
        val box = study.box.drawn(spaces, values)
        val color = Vector3d()
        for (channel in 0..2) {
            val strength = LightProbe(box, slot, study.colors, channel).shade(listOf(sample), texels).single()
            color.setComponent(channel, strength * (k.x() + k.y() + k.z()))
        }
        return if (color.isFinite) color else Vector3d()
    }
}

package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * How strongly a placed light arrives at points, whatever the normal there: I·F of the lighting model.
 *
 * @param unclamped whether sides that look away receive negative light; then the range is twice the strength.
 */
internal class Amplitudes(
    private val probe: LightProbe,
    val placement: Placement,
    private val texels: Map<String, Double>,
    val unclamped: Boolean,
) {
    /** I·F at [points] in view space. */
    fun at(points: List<Vector3dc>): DoubleArray {
        val samples =
            points.flatMap { p ->
                val n = placement.normalFor(placement.toLight(p).normalize())
                if (placement.isFlipped) n.negate()
                listOf(Sample(p, n), Sample(p, Vector3d(n).negate()))
            }
        val shades = probe.shade(samples, texels)
        val range = if (unclamped) 2.0 else 1.0
        return DoubleArray(points.size) { (shades[2 * it] - shades[2 * it + 1]) / range }
    }

    /** I·F at the distance [d] from the light along [direction], in the placement's own space. */
    fun along(
        directions: List<Vector3dc>,
        d: Double,
    ): DoubleArray = at(directions.map { placement.at(Vector3d(it).mul(d)) })
}

package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.max
import kotlin.random.Random

/** How the diffuse term of a placed light depends on the normal. */
internal class CosineTest(
    val unclamped: Boolean,
    val normalLength: Double,
    val error: Double,
    val floor: Double,
) {
    companion object {
        fun of(
            probe: LightProbe,
            placement: Placement,
            points: List<Vector3dc>,
            texels: Map<String, Double>,
        ): CosineTest {
            val random = Random(9)
            val sign = if (placement.isFlipped) -1.0 else 1.0
            val towards = points.map { p -> placement.normalFor(placement.toLight(p).normalize().mul(sign)) }
            val across = points.map { p ->
                placement.normalFor(Directions.around(placement.toLight(p).normalize(), PI / 2, random.nextDouble(2 * PI)))
            }
            val samples = points.indices.flatMap { i ->
                listOf(towards[i], Vector3d(towards[i]).negate(), across[i], Vector3d(towards[i]).mul(0.5)).map { Sample(points[i], it) }
            }
            val s = probe.shade(samples, texels)
            val full = points.indices.sumOf { s[4 * it] - s[4 * it + 2] }
            val away = points.indices.sumOf { s[4 * it + 1] - s[4 * it + 2] }
            val floor = points.indices.sumOf { s[4 * it + 2] }
            val shorter = points.indices.sumOf { s[4 * it + 3] - s[4 * it + 2] }
            val unclamped = away < -0.05 * full
            val error = error(probe, placement, points, texels, unclamped, sign, s)
            return CosineTest(unclamped, shorter / full, error, floor / full)
        }

        private fun error(
            probe: LightProbe,
            placement: Placement,
            points: List<Vector3dc>,
            texels: Map<String, Double>,
            unclamped: Boolean,
            sign: Double,
            s: DoubleArray,
        ): Double {
            val random = Random(10)
            val normals = points.map { List(NORMALS) { Directions.random(random) } }
            val values = probe.shade(points.indices.flatMap { i -> normals[i].map { Sample(points[i], it) } }, texels)
            var difference = 0.0
            var sum = 0.0
            for (i in points.indices) {
                val l = placement.toLight(points[i]).normalize().mul(sign)
                for (j in 0 until NORMALS) {
                    val cosine = placement.normalOf(normals[i][j]).dot(l)
                    val expected = (s[4 * i] - s[4 * i + 2]) * if (unclamped) cosine else max(cosine, 0.0)
                    val value = values[NORMALS * i + j] - s[4 * i + 2]
                    if (!value.isFinite()) continue
                    difference += abs(value - expected)
                    sum += max(abs(value), abs(expected))
                }
            }
            return if (sum > 0) difference / sum else 1.0
        }

        private const val NORMALS = 12
    }
}

package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.random.Random

/**
 * Whether what a vertex shader hands on survives interpolation: the middle of a triangle against a vertex that lies there.
 *
 * @param vectors relative difference where only the positions of the corners differ: 0 unless a vector was normalised too early.
 * @param normals relative difference where only the normals differ: 0 if they are normalised again.
 * @param perVertex how far the middle is from the mean of the corners' colours, relative: 0 if all lighting happens in the vertex shader.
 */
internal class InterpolationTest(
    val vectors: Double,
    val normals: Double,
    val perVertex: Double,
) {
    companion object {
        fun of(
            probe: LightProbe,
            placement: Placement,
            lit: List<Vector3dc>,
            texels: Map<String, Double>,
        ): InterpolationTest {
            val random = Random(7)
            val spread = triangles(placement, lit, random, DIFFERENT_POINTS, 0.0)
            val bent = triangles(placement, lit, random, 0.0, DIFFERENT_NORMALS)
            val middle = probe.shadeTriangles(spread, texels)
            val atMiddle = probe.shade(spread.chunked(3) { middle(it) }, texels)
            val corners = probe.shade(spread, texels)
            val mean = DoubleArray(middle.size) { (corners[3 * it] + corners[3 * it + 1] + corners[3 * it + 2]) / 3 }
            val normals = difference(probe.shadeTriangles(bent, texels), probe.shade(bent.chunked(3) { middle(it) }, texels))
            return InterpolationTest(difference(middle, atMiddle), normals, difference(middle, mean))
        }

        private fun triangles(
            placement: Placement,
            lit: List<Vector3dc>,
            random: Random,
            points: Double,
            normals: Double,
        ): List<Sample> =
            List(COUNT) { lit[it % lit.size] }.flatMap { p ->
                val l = placement.toLight(p)
                val towards = Vector3d(l).normalize().add(placement.toCamera(p).normalize()).normalize()
                val n = towards.add(Directions.random(random).mul(0.3)).normalize()
                val reach = points * l.length()
                List(3) {
                    val corner = Vector3d(p).add(Directions.random(random).mul(reach))
                    Sample(corner, placement.normalFor(Vector3d(n).add(Directions.random(random).mul(normals)).normalize()))
                }
            }

        private fun middle(corners: List<Sample>): Sample {
            val p = corners.fold(Vector3d()) { sum, it -> sum.add(it.position) }.div(3.0)
            val n = corners.fold(Vector3d()) { sum, it -> sum.add(it.normal) }.normalize()
            return Sample(p, n)
        }

        /** Differences relative to what is there, all triangles together; those that only one of both lights count half. */
        private fun difference(
            a: DoubleArray,
            b: DoubleArray,
        ): Double {
            var difference = 0.0
            var sum = 0.0
            for (i in a.indices) {
                val larger = maxOf(abs(a[i]), abs(b[i]))
                if (!larger.isFinite() || larger == 0.0) continue
                difference += abs(a[i] - b[i]) / larger
                sum += 1.0
            }
            return if (sum > 0) difference / sum else 0.0
        }

        private const val COUNT = 120
        private const val DIFFERENT_POINTS = 0.6
        private const val DIFFERENT_NORMALS = 0.8
    }
}

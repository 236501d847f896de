package cga.grading.reading

import cga.reader.shader.Stage
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.pow
import kotlin.random.Random

/** How a vector comes to the middle of a triangle. */
internal enum class Blend {
    /** Divided by its length there, as it has to be. */
    LATE,

    /** Divided by its length at the corners, and there again. */
    EARLY,

    /** Divided by its length at the corners only. */
    EARLY_ONLY,

    /** As it is. */
    NEVER,
}

/**
 * What interpolation makes of a cosine.
 *
 * @property isPerVertex whether it is computed at the corners and is no cosine in between.
 */
internal class Blends(val normal: Blend, val light: Blend, val eye: Blend, val isPerVertex: Boolean = false)

/** Tries inside of large triangles, whose corners have different normals, how the vectors of a factor were interpolated. */
internal class Interpolation(private val reading: ProgramReading) {
    private class Triangle(val corners: List<SamplePoint>, val weights: DoubleArray, val trace: Trace)

    private val triangles: List<Triangle> by lazy {
        val random = Random(2)
        List(COUNT) {
            val corners = List(3) { SamplePoint.random(random, reading.probe.attributes, reading.position, SIZE) }
            val raw = List(3) { random.nextDouble(0.2, 1.0) }
            val weights = DoubleArray(3) { raw[it] / raw.sum() }
            reading.inside(near(corners), weights)?.let { Triangle(near(corners), weights, it) }
        }.filterNotNull()
    }

    /** The same corners with normals that do not cancel out. */
    private fun near(corners: List<SamplePoint>): List<SamplePoint> =
        corners.map { corner ->
            corner.turned {
                location,
                direction,
                ->
                Vector3d(direction).mul(0.5).add(corners[0].directions.getValue(location)).normalize()
            }
        }

    fun of(factor: Factor.Cosine): Blends? =
        if (factor.node.line.stage ==
            Stage.VERTEX
        ) {
            Blends(Blend.NEVER, Blend.NEVER, Blend.LATE, isPerVertex = true)
        } else {
            find(factor.node, 1.0, factor.normal, factor.light, null) { n, l, _ ->
                clamped(factor.light.sign * n.dot(l), factor.clamp)
            }
        }

    fun of(factor: Factor.Highlight): Blends? =
        if (factor.node.line.stage ==
            Stage.VERTEX
        ) {
            Blends(Blend.NEVER, Blend.NEVER, Blend.NEVER, isPerVertex = true)
        } else {
            find(factor.node, factor.exponent, factor.normal, factor.light, factor.eye) { n, l, v ->
                val light = l.mul(factor.light.sign)
                val eye = v.mul(factor.eye.sign)
                val cosine = when (factor.lobe) {
                    Lobe.HALF -> light.add(eye).normalize().dot(n)
                    Lobe.HALF_RAW -> light.add(eye).dot(n)
                    Lobe.HALF_MEAN -> light.add(eye).mul(0.5).dot(n)
                    Lobe.REFLECTED -> Vector3d(n).mul(2 * n.dot(light)).sub(light).dot(eye)
                }
                maxOf(cosine, 0.0)
            }
        }

    private fun find(
        node: Node,
        exponent: Double,
        normal: Use,
        light: WayUse,
        eye: WayUse?,
        formula: (Vector3d, Vector3d, Vector3d) -> Double,
    ): Blends? {
        val values = triangles.map { triangle ->
            triangle.trace.nodes.find { it.key == node.key }?.value?.let {
                if (exponent ==
                    1.0
                ) {
                    it
                } else {
                    it.pow(1 / exponent)
                }
            }
        }
        val present = values.indices.filter { values[it]?.isFinite() == true }
        if (present.size < FEWEST) return null
        for (n in blends(normal.isUnit)) {
            for (l in blends(light.isUnit)) {
                for (v in if (eye == null) listOf(Blend.LATE) else blends(eye.isUnit)) {
                    val fits = present.all { i ->
                        val triangle = triangles[i]
                        val expected = formula(
                            blended(triangle, n) { normal.vector.at(it.position, reading.finder.normalOf(it), false) },
                            blended(triangle, l) { way(it, light) },
                            eye?.let { use -> blended(triangle, v) { way(it, use) } } ?: Vector3d(),
                        )
                        abs(expected - (values[i] ?: 0.0)) < EXACT
                    }
                    if (fits) return Blends(n, l, v)
                }
            }
        }
        return null
    }

    private fun way(point: SamplePoint, use: WayUse): Vector3d =
        use.way.vector.at(point.position, reading.finder.normalOf(point), false).mul(use.way.sign)

    private fun blends(isUnit: Boolean) = if (isUnit) {
        listOf(
            Blend.LATE,
            Blend.EARLY_ONLY,
            Blend.EARLY,
            Blend.NEVER,
        )
    } else {
        listOf(Blend.NEVER, Blend.LATE)
    }

    private fun blended(triangle: Triangle, blend: Blend, vector: (SamplePoint) -> Vector3d): Vector3d {
        val sum = Vector3d()
        for ((corner, weight) in triangle.corners.zip(triangle.weights.toList())) {
            val at = vector(corner)
            if (blend == Blend.EARLY || blend == Blend.EARLY_ONLY) at.normalize()
            sum.add(at.mul(weight))
        }
        return if (blend == Blend.LATE || blend == Blend.EARLY) sum.normalize() else sum
    }

    private fun clamped(x: Double, clamp: Clamp) =
        when (clamp) {
            Clamp.NONE -> x
            Clamp.ZERO -> maxOf(x, 0.0)
            Clamp.ZERO_TO_ONE -> x.coerceIn(0.0, 1.0)
            Clamp.ABSOLUTE -> abs(x)
        }

    private companion object {
        const val COUNT = 24
        const val FEWEST = 6
        const val SIZE = 3.0
        const val EXACT = 1e-6
    }
}

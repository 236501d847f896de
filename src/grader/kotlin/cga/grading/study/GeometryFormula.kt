package cga.grading.study

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector4d
import org.lwjgl.opengl.GL33C.GL_FLOAT_MAT4
import kotlin.math.abs
import kotlin.math.max
import kotlin.random.Random

/**
 * How a program takes a vertex to the screen.
 *
 * @param positionLocation the attribute that is the position.
 * @param product names of the matrices whose product is applied to it, left to right; empty where it is no such product.
 */
internal class GeometryFormula(
    val positionLocation: Int,
    val product: List<String>,
) {
    companion object {
        /**
         * Finds the formula of [program] by what it does with matrices of random numbers, where no two products are alike.
         * Null when the clip position depends on no attribute.
         */
        fun of(
            rig: ProbeRig,
            program: ProbeProgram,
            locations: Collection<Int>,
            values: Map<String, FloatArray>,
        ): GeometryFormula? {
            val random = Random(1)
            val matrices = program.uniforms.filter { it.type == GL_FLOAT_MAT4 }.map { it.name }
            val generic = values + matrices.associateWith { FloatArray(16) { random.nextDouble(-1.0, 1.0).toFloat() } }
            val position = locations.filter {
                movesVertex(rig, program, locations, it, values) ||
                    movesVertex(rig, program, locations, it, generic)
            }
            val location = position.firstOrNull() ?: return null
            val points = List(6) { Vector4d(random.nextDouble(-1.0, 1.0), random.nextDouble(-1.0, 1.0), random.nextDouble(-1.0, 1.0), 1.0) }
            val feed = Feed(points.size)
            points.forEachIndexed { i, p -> feed.set(location, i, p.x, p.y, p.z) }
            val clip = rig.clip(program, feed, generic)
            // As the shader sees them: rounded to floats.
            points.forEach { it.set(it.x.toFloat().toDouble(), it.y.toFloat().toDouble(), it.z.toFloat().toDouble(), 1.0) }
            val product =
                products(matrices).firstOrNull { agrees(product(it, generic), points, clip) }
                    ?: affineProduct(rig, program, matrices, values, feed, points)
            return GeometryFormula(location, product ?: emptyList())
        }

        /** The same where a fourth coordinate is replaced by 1 on the way: matrices that leave it at 1 do not notice. */
        private fun affineProduct(
            rig: ProbeRig,
            program: ProbeProgram,
            matrices: List<String>,
            values: Map<String, FloatArray>,
            feed: Feed,
            points: List<Vector4d>,
        ): List<String>? {
            val random = Random(15)
            val affine = values + matrices.associateWith { affine(random) }
            val clip = rig.clip(program, feed, affine)
            return products(matrices).firstOrNull { agrees(product(it, affine), points, clip) }
        }

        /** The product of the matrices called [names], left to right. */
        fun product(
            names: List<String>,
            values: Map<String, FloatArray>,
        ): Matrix4d = names.fold(Matrix4d()) { all, name -> all.mul(matrix(values.getValue(name))) }

        private fun affine(random: Random) =
            FloatArray(16) { i ->
                if (i == 15) {
                    1f
                } else if (i % 4 == 3) {
                    0f
                } else {
                    random.nextDouble(-1.0, 1.0).toFloat()
                }
            }

        /** A matrix of OpenGL's column order. */
        fun matrix(numbers: FloatArray): Matrix4d = Matrix4d().set(DoubleArray(16) { numbers[it].toDouble() })

        private fun products(names: List<String>): Sequence<List<String>> {
            val few = names.take(MAX_MATRICES)
            val singles = few.asSequence().map { listOf(it) }
            val pairs = singles.flatMap { one -> few.map { one + it } }
            return singles + pairs + pairs.flatMap { two -> few.map { two + it } }
        }

        private fun movesVertex(
            rig: ProbeRig,
            program: ProbeProgram,
            locations: Collection<Int>,
            location: Int,
            values: Map<String, FloatArray>,
        ): Boolean {
            val feed = Feed(2)
            for (each in locations) for (i in 0..1) feed.set(each, i, 0.3, 0.5, 0.7)
            feed.set(location, 1, 0.9, 0.2, 0.4)
            val clip = rig.clip(program, feed, values)
            return (0..3).any { clip[it] != clip[4 + it] }
        }

        private fun agrees(
            matrix: Matrix4dc,
            points: List<Vector4d>,
            clip: FloatArray,
        ): Boolean {
            var worst = 0.0
            var largest = 0.0
            points.forEachIndexed { i, p ->
                val expected = matrix.transform(p, Vector4d())
                for (axis in 0..3) {
                    worst = max(worst, abs(expected[axis] - clip[4 * i + axis]))
                    largest = max(largest, abs(expected[axis]))
                }
            }
            // Three products of four terms each, every one rounded to a float: 12·2⁻²⁴ of sums that are a few times larger than their result.
            return worst <= 1e-5 * largest
        }

        private const val MAX_MATRICES = 8
    }
}

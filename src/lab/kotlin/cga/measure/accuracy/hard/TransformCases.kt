package cga.measure.accuracy.hard

import cga.exercise.components.geometry.NormalMatrix
import cga.exercise.components.geometry.Transformable
import org.joml.Matrix3d
import org.joml.Matrix3f
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.random.Random

/** Matrices that squeeze, mirror and pile up. */
internal object TransformCases {
    fun measure(): List<HardCase> =
        listOf(
            normals("scale 1e-13", "the determinant, 1e-39, is 0") { Vector3d(1e-13) },
            normals("scale 1e13", "the determinant, 1e39, is ∞") { Vector3d(1e13) },
            normals("scale 1e-13, 1, 1e13", "") { Vector3d(1e-13, 1.0, 1e13) },
            normals("scale −1, 2, 0.5 (mirrored)", "normals lean the wrong way", transposed = false, spread = 4.0) {
                Vector3d(-1.0, 2.0, 0.5)
            },
            chain(),
        )

    /**
     * The direction of normals of a model that is scaled and then turned: turned the other way round, floats would not keep such scales
     * apart, and there were nothing left to measure.
     */
    private fun normals(
        name: String,
        failure: String,
        transposed: Boolean = true,
        spread: Double = 1.0,
        scale: () -> Vector3d,
    ): HardCase {
        val random = Random(5)
        var naiveError = 0.0
        var ourError = 0.0
        repeat(300) {
            val turn = Matrix3d().rotateXYZ(random.nextDouble(6.0), random.nextDouble(6.0), random.nextDouble(6.0))
            val matrix = Matrix4f(Matrix4d().set3x3(Matrix3d(turn).scale(scale())))
            val normal = random.direction()
            val truth = exactNormal(matrix, normal)
            val ours = NormalMatrix().of(Matrix4d(matrix), Matrix3f()).transform(Vector3f(normal))
            val inverse = Matrix3f(matrix).invert()
            val naive = (if (transposed) inverse.transpose() else inverse).transform(Vector3f(normal))
            naiveError = worse(naiveError, angle(truth, naive))
            ourError = worse(ourError, angle(truth, ours))
        }
        // Each element rounds by u of itself and the product with the normal by 3u: 4u of a sum that is at most √3 in each of three
        // numbers, 12u or 6 ulp, over what the least stretched direction keeps of the most stretched one's length.
        return HardCase(
            "normals, $name",
            if (transposed) "transposed inverse in floats" else "inverse, not transposed",
            naiveError,
            "sign(det)·cofactors in double",
            ourError,
            6 * spread,
            ErrorUnit.ULP,
            failure,
        )
    }

    /** cof(M)·n in double; the elements are floats, so that each product in a cofactor is exact and each cofactor rounds once. */
    private fun exactNormal(
        matrix: Matrix4f,
        normal: Vector3d,
    ): Vector3d {
        val m = Matrix3d(Matrix3f(matrix))
        val x = m.getColumn(0, Vector3d())
        val y = m.getColumn(1, Vector3d())
        val z = m.getColumn(2, Vector3d())
        val cof = Matrix3d(y.cross(z, Vector3d()), z.cross(x, Vector3d()), x.cross(y, Vector3d()))
        return cof.transform(normal, Vector3d()).mul(if (y.cross(z, Vector3d()).dot(x) < 0) -1.0 else 1.0)
    }

    /** 1,000 parents, each turned, moved and scaled a little. */
    private fun chain(): HardCase {
        val random = Random(6)
        val links = List(1_000) { link(random) }
        val truth = Matrix4d()
        val naive = Matrix4f()
        for (link in links) {
            truth.mul(Matrix4d(link))
            naive.mul(link)
        }
        val leaf = links.fold(null as Transformable?) { parent, link -> Transformable(link, parent) }
        val ours = checkNotNull(leaf).getWorldModelMatrix()
        return HardCase(
            "a chain of 1,000 parents",
            "product of float matrices",
            ulps(truth, naive),
            "product in double, rounded once",
            ulps(truth, ours),
            // Half an ulp, and the 1,000 roundings of doubles, 2⁻²⁹ each of an ulp, with the growth of up to 1,000-fold.
            0.51,
            ErrorUnit.ULP,
            "",
        )
    }

    private fun link(random: Random) =
        Matrix4f()
            .translate(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, random.nextFloat() - 0.5f)
            .rotateXYZ(random.nextFloat(), random.nextFloat(), random.nextFloat())
            .scale(1f + (random.nextFloat() - 0.5f) / 100)

    /** The largest error of a number, in ulps of the largest of its column. */
    private fun ulps(
        truth: Matrix4d,
        computed: Matrix4f,
    ): Double =
        (0..3).maxOf { column ->
            val largest = (0..2).maxOf { abs(truth.get(column, it)) }
            (0..3).maxOf { row -> abs(truth.get(column, row) - computed.get(column, row)) } / Math.ulp(largest.toFloat())
        }

    /** Between two directions, in ulps of 1. */
    private fun angle(
        truth: Vector3d,
        computed: Vector3f,
    ): Double {
        val a = truth.normalize(Vector3d())
        val b = Vector3d(computed).normalize()
        return if (b.isFinite) atan2(a.cross(b, Vector3d()).length(), a.dot(b)) / Math.ulp(1f) else Double.NaN
    }

    private fun worse(
        a: Double,
        b: Double,
    ): Double = if (a.isNaN() || b.isNaN()) Double.NaN else maxOf(a, b)

    private fun Random.direction() = Vector3d(nextDouble(-1.0, 1.0), nextDouble(-1.0, 1.0), nextDouble(-1.0, 1.0)).normalize()
}

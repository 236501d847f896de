package cga.grading.reading

import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs

/** The spaces of the scene. */
internal enum class Space { VIEW, WORLD, MODEL }

/**
 * A vector of a shader, known as a function of the vertex: fromPosition · p + fromNormal · n + constant, where p and the unit vector n are in model space.
 *
 * @property isUnit whether it is divided by its length.
 * @property isEnd whether [nodes] are where it leads to, and itself it is nowhere: `distance(a, b)` has no vector.
 */
internal class KnownVector(
    val key: Long,
    val fromPosition: Matrix3dc,
    val fromNormal: Matrix3dc,
    val constant: Vector3dc,
    val isUnit: Boolean,
    val line: ShaderLine,
    val nodes: List<Node>,
    val isEnd: Boolean = false,
) {
    /** It at [point], whose normal is [normal]. */
    fun at(point: Vector3dc, normal: Vector3dc, isUnit: Boolean = this.isUnit): Vector3d {
        val result = fromPosition.transform(point, Vector3d()).add(fromNormal.transform(normal, Vector3d())).add(constant)
        return if (isUnit) result.normalize() else result
    }

    val dependsOnPosition: Boolean get() = !isZero(fromPosition)
    val dependsOnNormal: Boolean get() = !isZero(fromNormal)

    companion object {
        fun isZero(m: Matrix3dc): Boolean = (0..2).all { c -> (0..2).all { r -> abs(m.get(c, r)) < 1e-9 } }
    }
}

/** Finds the vectors of a program that are affine in position and normal, and the unit vectors made of such. */
internal class VectorFinder(private val samples: Samples, private val normal: Int?) {
    private val rows = samples.points.map { row(it) }
    private val solver = LeastSquares(rows)

    private fun row(point: SamplePoint): DoubleArray {
        val n = normal?.let { point.directions.getValue(it) } ?: Vector3d()
        val p = point.position
        val all = doubleArrayOf(1.0, p.x, p.y, p.z, n.x, n.y, n.z)
        return if (normal == null) all.copyOf(4) else all
    }

    /** Each once: vectors that are the same in all samples count as one. */
    fun find(): List<KnownVector> {
        val byKey = samples.traces.map { trace -> trace.vectors.associateBy { it.key } }
        val all = byKey[0]
            .keys
            .filter { key -> byKey.all { key in it } }
            .map { key -> byKey.map { it.getValue(key) } }
            .filter { runs -> runs.all { run -> run.nodes.all { it.value.isFinite() } } }
        val affine = ArrayList<KnownVector>()
        val rest = ArrayList<List<NodeVector>>()
        for (runs in all) affine(runs)?.let { affine += it } ?: rest.add(runs)
        val once = affine.distinctBy { rounded(it) }
        return once + rest.mapNotNull { unit(it, once) }.distinctBy { rounded(it) }
    }

    private fun rounded(v: KnownVector): List<Any> =
        listOf(v.isUnit) +
            samples.points
                .take(3)
                .flatMap { point -> v.at(point.position, normalOf(point)).let { listOf(it.x, it.y, it.z) } }
                .map { Math.round(it * 1e7) }

    fun normalOf(point: SamplePoint): Vector3d = normal?.let { point.directions.getValue(it) } ?: Vector3d(0.0, 0.0, 1.0)

    private fun affine(runs: List<NodeVector>): KnownVector? {
        val fits = (0..2).map { axis -> solver.solve(DoubleArray(runs.size) { runs[it].nodes[axis].value }) ?: return null }
        val p = Matrix3d()
        val n = Matrix3d()
        for (row in 0..2) {
            for (column in 0..2) {
                p.set(column, row, fits[row][1 + column])
                n.set(column, row, if (normal == null) 0.0 else fits[row][4 + column])
            }
        }
        return KnownVector(runs[0].key, p, n, Vector3d(fits[0][0], fits[1][0], fits[2][0]), false, runs[0].line, runs[0].nodes)
    }

    /** What [runs] is the direction of. */
    private fun unit(runs: List<NodeVector>, known: List<KnownVector>): KnownVector? {
        fun value(i: Int) = runs[i].nodes.let { Vector3d(it[0].value, it[1].value, it[2].value) }
        if (runs.indices.any { abs(value(it).length() - 1) > EXACT }) return null
        val of = known.find { vector ->
            runs.indices.all { i ->
                val point = samples.points[i]
                vector.at(point.position, normalOf(point), isUnit = true).distance(value(i)) < EXACT
            }
        } ?: return null
        return KnownVector(runs[0].key, of.fromPosition, of.fromNormal, of.constant, true, runs[0].line, runs[0].nodes)
    }

    private companion object {
        /** Runs are in double precision; the matrices of one run are the same as those of another. */
        const val EXACT = 1e-9
    }
}

/**
 * A vector as a way from the surface to a fixed point.
 *
 * @property space that surface is in.
 * @property place where the point is in that space, as the shader computes it.
 * @property sign −1 where the vector leads from the point to the surface.
 */
internal class ToPoint(val vector: KnownVector, val space: Space, val place: Vector3dc, val sign: Double)

/** Where it leads to, in view space. */
internal fun ToPoint.inView(spaces: Spaces): Vector3d =
    when (space) {
        Space.VIEW -> Vector3d(place)
        Space.WORLD -> (spaces.view ?: spaces.modelView).transformPosition(Vector3d(place))
        Space.MODEL -> spaces.modelView.transformPosition(Vector3d(place))
    }

/** The ways from the surface to [ends], in every space. */
internal fun waysTo(ends: List<KnownVector>, spaces: Spaces): List<ToPoint> =
    ends.flatMap { end ->
        spaces.all().map { (space, matrix) ->
            val constant = Vector3d(end.constant).sub(matrix.m30(), matrix.m31(), matrix.m32())
            val vector =
                KnownVector(end.key, Matrix3d(matrix).scale(-1.0), Matrix3d().zero(), constant, false, end.line, end.nodes, isEnd = true)
            ToPoint(vector, space, end.constant, 1.0)
        }
    }

/** What [vector] leads to, null where it is no such way. */
internal fun toPoint(vector: KnownVector, spaces: Spaces): ToPoint? {
    if (vector.dependsOnNormal || !vector.dependsOnPosition) return null
    for ((space, matrix) in spaces.all()) {
        for (sign in listOf(1.0, -1.0)) {
            val wanted = Matrix3d(matrix).scale(-sign)
            if (!wanted.equals(vector.fromPosition, 1e-6)) continue
            // vector = sign · (place − matrix · p)
            val offset = Vector3d(matrix.m30(), matrix.m31(), matrix.m32())
            return ToPoint(vector, space, Vector3d(vector.constant).mul(sign).add(offset), sign)
        }
    }
    return null
}

/** The matrices from model space, the right one first. */
internal fun Spaces.all(): Map<Space, Matrix4dc> =
    buildMap {
        put(Space.VIEW, modelView)
        model?.let { put(Space.WORLD, it) }
        put(Space.MODEL, org.joml.Matrix4d())
    }

package cga.grading.reading

import cga.grading.capture.CapturedDraw
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector4d
import kotlin.math.abs

/**
 * How a draw's vertices get to the screen: gl_Position = projection · modelView · vertex.
 *
 * @property modelView model space → view space; [projection] view space → clip space.
 * @property view world space → view space, and [model] model space → world space; both null where nothing tells them apart.
 */
internal class Spaces(
    val projection: Matrix4dc,
    val modelView: Matrix4dc,
    val view: Matrix4dc?,
    val model: Matrix4dc?,
)

/**
 * Finds the matrices of a program's draws: among its uniforms of 16 numbers, and among what the vertex shader makes of a vertex on the way, which
 * for every affine step is a matrix, too.
 */
internal class SpaceFinder(private val probe: Probe, private val position: Int) {
    private class Chain(val modelView: Any?, val view: Any?, val model: Any?)

    private var chain: Chain? = null

    /**
     * Finds out which matrix is which.
     *
     * @param frames the program's draws, picture by picture.
     * @param draw the one whose matrices differ most from none.
     */
    fun learn(frames: List<List<CapturedDraw>>, draw: CapturedDraw) {
        val maps = maps(ProgramReading.values(draw)) ?: return
        val whole = maps[WHOLE] ?: return
        val rest = maps - WHOLE
        val modelView = rest.keys.find { isPerspective(whole, rest.getValue(it)) }
        val product = modelView?.let(rest::getValue) ?: split(whole)?.second ?: return
        chain = Chain(modelView, null, null)
        val moving = rest.filterValues { !isIdentity(it) }
        val sent = moving.keys.filterIsInstance<String>().filter { isView(it, frames) }
        val pair = (sent + (moving.keys - sent.toSet()))
            .asSequence()
            .flatMap { view -> moving.keys.asSequence().map { view to it } }
            .find { (view, model) -> view != model && isNear(Matrix4d(rest.getValue(view)).mul(rest.getValue(model)), product) }
        chain = when {
            pair != null && (pair.first in sent || sent.isEmpty()) -> Chain(modelView, pair.first, pair.second)
            sent.isNotEmpty() -> Chain(modelView, sent[0], null)
            else -> Chain(modelView, null, alone(whole, moving))
        }
    }

    /** Whether [name] is the same for all that is drawn in a picture, and whether through it some thing, the ground, keeps its place in all pictures. */
    private fun isView(name: String, frames: List<List<CapturedDraw>>): Boolean {
        val some = frames.filter { it.isNotEmpty() }.let { all -> all.filterIndexed { i, _ -> i % (1 + all.size / FRAMES) == 0 } }
        if (some.any { draws -> draws.map { matrixOf(it, name) }.distinct().size != 1 }) return false
        val places = some.flatMap { it }.groupBy { draw -> draw.attributes.map { it.buffer } to draw.count }.values.filter {
            it.size >=
                some.size
        }
        return places.any { same -> same.map { model(it, name) ?: return false }.zipWithNext().all { (a, b) -> isNear(a, b) } }
    }

    private fun matrixOf(draw: CapturedDraw, name: String): List<Float>? =
        draw.uniforms.find { it.name == name }?.numbers?.toList()?.takeIf { m ->
            m.size == 16 && m[3] == 0f && m[7] == 0f && m[11] == 0f &&
                m[15] == 1f
        }

    private fun model(draw: CapturedDraw, view: String): Matrix4d? {
        val spaces = of(ProgramReading.values(draw)) ?: return null
        val numbers = matrixOf(draw, view) ?: return null
        return Matrix4d().set(DoubleArray(16) { numbers[it].toDouble() }).invert().mul(spaces.modelView)
    }

    /** The matrix without which what is left of [whole] is a rigid view and a projection: the model's. */
    private fun alone(whole: Matrix4d, matrices: Map<Any, Matrix4d>): Any? =
        matrices.keys.find { key ->
            val view = split(Matrix4d(whole).mul(Matrix4d(matrices.getValue(key)).invert()))?.second?.let { Matrix3d(it) }
            view != null && Matrix3d(view).mul(view.transpose(Matrix3d())).equals(Matrix3d(), NEAR)
        }

    /** The matrices of a draw with [values], null where its vertices do not get to the screen that way. */
    fun of(values: Map<String, DoubleArray>): Spaces? {
        val maps = maps(values) ?: return null
        val whole = maps[WHOLE] ?: return null
        val chain = chain ?: return null
        val given = chain.modelView?.let(maps::get)
        val (projection, modelView) =
            if (given != null) Matrix4d(whole).mul(Matrix4d(given).invert()) to given else split(whole) ?: return null
        val model = chain.model?.let(maps::get)
        val view = chain.view?.let(maps::get) ?: model?.let { Matrix4d(modelView).mul(Matrix4d(it).invert()) }
        return Spaces(projection, modelView, view, model ?: view?.let { Matrix4d(it).invert().mul(modelView) })
    }

    /** Every matrix that there is, by the name of its uniform or the key of the vector that it leads to. */
    private fun maps(values: Map<String, DoubleArray>): Map<Any, Matrix4d>? {
        probe.set(values)
        val corners = CORNERS.map { probe.vertexAt(mapOf(position to it)) ?: return null }
        val result = HashMap<Any, Matrix4d>()
        for ((name, numbers) in values) if (numbers.size == 16) result[name] = matrix(numbers)
        val vectors = corners.map { trace -> trace.vectors.associateBy { it.key } }
        for (key in vectors[0].keys) {
            val ends = vectors.map { all -> all[key]?.nodes?.map { it.value }?.let { doubleArrayOf(it[0], it[1], it[2], 1.0) } }
            affine(ends)?.let { result[key] = it }
        }
        affine(corners.map { trace -> trace.position?.map { it.value }?.toDoubleArray() })?.let { result[WHOLE] = it }
        return result
    }

    /** The matrix that takes the origin and the ends of the axes to [ends], if it takes the last corner where it should be. */
    private fun affine(ends: List<DoubleArray?>): Matrix4d? {
        if (ends.any { end -> end == null || end.any { !it.isFinite() } }) return null
        val all = ends.filterNotNull()
        val numbers = DoubleArray(16) { i -> if (i < 12) all[1 + i / 4][i % 4] - all[0][i % 4] else all[0][i % 4] }
        val matrix = matrix(numbers)
        val last = CORNERS.last().let { matrix.transform(Vector4d(it[0], it[1], it[2], 1.0)) }
        val size = 1 + numbers.maxOf { abs(it) }
        val isAffine = (0..3).all { abs(last[it] - all.last()[it]) < EXACT * size }
        return matrix.takeIf { isAffine && abs(it.determinant3x3()) > TINY }
    }

    private fun matrix(numbers: DoubleArray) = Matrix4d().set(numbers)

    private fun isPerspective(whole: Matrix4d, modelView: Matrix4d): Boolean {
        if (abs(modelView.determinant3x3()) < TINY) return false
        val p = Matrix4d(whole).mul(Matrix4d(modelView).invert())
        val zeros = listOf(p.m01(), p.m02(), p.m03(), p.m10(), p.m12(), p.m13(), p.m30(), p.m31(), p.m33())
        return zeros.all { abs(it) < NEAR } && abs(p.m23() + 1) < NEAR
    }

    /** The product of a symmetric perspective and an even model-view, taken apart by its rows: (a·x, b·y, c·z + d·w, −z). */
    private fun split(whole: Matrix4d): Pair<Matrix4d, Matrix4d>? {
        val (x, y, z, w) = List(4) { whole.getRow(it, Vector4d()) }
        val back = Vector4d(w).negate()
        val scale = length(back)
        if (scale < TINY) return null
        val a = length(x) / scale
        val b = length(y) / scale
        val c = (z.x * back.x + z.y * back.y + z.z * back.z) / (scale * scale)
        if (a < TINY || b < TINY) return null
        val modelView = Matrix4d().setRow(0, x.div(a)).setRow(1, y.div(b)).setRow(2, back)
        return Matrix4d().zero().m00(a).m11(b).m22(c).m32(z.w - c * back.w).m23(-1.0) to modelView
    }

    private fun length(row: Vector4d) = Math.sqrt(row.x * row.x + row.y * row.y + row.z * row.z)

    private fun isIdentity(m: Matrix4dc) = isNear(m, Matrix4d())

    private fun isNear(a: Matrix4dc, b: Matrix4dc) = a.equals(b, NEAR)

    private companion object {
        const val WHOLE = "gl_Position"

        /** Of all pictures so many tell what the others would. */
        const val FRAMES = 6

        /** Matrices are sent as floats. */
        const val NEAR = 1e-4
        const val EXACT = 1e-9
        const val TINY = 1e-12

        /** The origin, the ends of the axes, and one more to see whether the step is affine. */
        val CORNERS = listOf(
            doubleArrayOf(0.0, 0.0, 0.0, 1.0),
            doubleArrayOf(1.0, 0.0, 0.0, 1.0),
            doubleArrayOf(0.0, 1.0, 0.0, 1.0),
            doubleArrayOf(0.0, 0.0, 1.0, 1.0),
            doubleArrayOf(0.7, -1.3, 0.4, 1.0),
        )
    }
}

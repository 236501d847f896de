package cga.grading.study

import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Matrix4d
import org.joml.Matrix4dc
import kotlin.math.abs

/**
 * The spaces of one draw.
 *
 * @param view null where the shader never sees world space.
 * @param sentNormals the turn of the matrix that is sent for the normals alone, null where none is.
 */
internal class Spaces(
    val projection: Matrix4dc,
    val view: Matrix4dc?,
    val model: Matrix4dc?,
    val modelView: Matrix4dc,
    val sentNormals: Matrix3dc? = null,
) {
    companion object {
        /** The spaces for the uniforms [values] of one draw, which [formula] multiplies; null where no projection can be made out. */
        fun of(
            formula: GeometryFormula,
            matrices: List<String>,
            values: Map<String, FloatArray>,
        ): Spaces? = multiplied(formula, matrices, values)?.run { Spaces(projection, view, model, modelView, sentNormals(formula, values)) }

        private fun sentNormals(formula: GeometryFormula, values: Map<String, FloatArray>): Matrix3d? {
            val others = values.filter { (name, numbers) -> name !in formula.product && numbers.size in NORMAL_SIZES }
            return others
                .toSortedMap(
                    compareByDescending<String> { NORMAL_NAME.containsMatchIn(it) }.thenBy { it },
                ).values
                .firstNotNullOfOrNull(::turn)
        }

        /** What [numbers] of a matrix of 3 x 3 or 4 x 4 turn; null where they do more than to turn and to scale evenly. */
        private fun turn(numbers: FloatArray): Matrix3d? {
            val rows = if (numbers.size == 9) 3 else 4
            val m = Matrix4d(Matrix3d().apply { for (i in 0..8) set(i / 3, i % 3, numbers[i / 3 * rows + i % 3].toDouble()) })
            return if (m.isEven()) m.rotationPart() else null
        }

        /** Splits what [formula] multiplies. */
        private fun multiplied(
            formula: GeometryFormula,
            matrices: List<String>,
            values: Map<String, FloatArray>,
        ): Spaces? {
            val factors = formula.product.map { GeometryFormula.matrix(values.getValue(it)) }
            if (factors.isEmpty()) return null
            val others = matrices
                .filter {
                    it !in formula.product
                }.sortedByDescending { VIEW_NAME.containsMatchIn(it) }
                .map { GeometryFormula.matrix(values.getValue(it)) }
            if (factors.size == 3 &&
                isProjection(factors[0])
            ) {
                return Spaces(factors[0], factors[1], factors[2], factors[1].mul(factors[2], Matrix4d()))
            }
            if (factors.size == 2 && isProjection(factors[0])) return split(factors[0], factors[1], others)
            val whole = factors.fold(Matrix4d()) { all, factor -> all.mul(factor) }
            if (factors.size == 2) {
                val view = others.firstOrNull { isProjection(factors[0].mul(it.invert(Matrix4d()), Matrix4d())) }
                if (view != null) {
                    return Spaces(factors[0].mul(view.invert(Matrix4d()), Matrix4d()), view, factors[1], view.mul(factors[1], Matrix4d()))
                }
            }
            val modelView =
                (others + products(others)).firstOrNull { isProjection(whole.mul(it.invert(Matrix4d()), Matrix4d())) }
                    ?: return if (factors.size > 2) null else joined(factors, others)
            return split(whole.mul(modelView.invert(Matrix4d()), Matrix4d()), modelView, others)
        }

        /** Projection and view, or all three, have been multiplied before they were sent. */
        private fun joined(
            factors: List<Matrix4d>,
            others: List<Matrix4d>,
        ): Spaces? {
            val (projection, moved) = ViewProjection.of(factors[0])?.let { it.projection to it.view } ?: return null
            if (factors.size == 2) return Spaces(projection, moved, factors[1], moved.mul(factors[1], Matrix4d()))
            val model = others.firstOrNull { isPlace(it) && abs(it.scale() / moved.scale() - 1) < 1e-3 }
            return Spaces(projection, model?.let { moved.mul(it.invert(Matrix4d()), Matrix4d()) }, model, moved)
        }

        /** Looks for the view matrix among [others]: the one that makes [modelView] with one of them. */
        private fun split(
            projection: Matrix4d,
            modelView: Matrix4d,
            others: List<Matrix4d>,
        ): Spaces {
            // The way back is sent for the normals, and is a place as well.
            val ways = others.filterNot { isNear(it.mul(modelView, Matrix4d()), Matrix4d()) }
            for (view in ways) {
                for (model in ways) {
                    if (isNear(view.mul(model, Matrix4d()), modelView)) return Spaces(projection, view, model, modelView)
                }
            }
            val view = ways.firstOrNull { isPlace(it) && it.invert(Matrix4d()).mul(modelView).isEven() && !isNear(it, modelView) }
            return Spaces(projection, view, view?.invert(Matrix4d())?.mul(modelView), modelView)
        }

        /** Whether [m] moves, turns and scales evenly, and moves at all: what a matrix for normals does not. */
        private fun isPlace(m: Matrix4dc): Boolean = m.isEven() && abs(m.m30()) + abs(m.m31()) + abs(m.m32()) > 0

        /** [model] as far as floats tell: what places alike have in common. */
        fun rounded(model: Matrix4dc): List<Long> = List(16) { Math.round(model.get(it / 4, it % 4) * ROUND) }

        private const val ROUND = 1e4
        private val NORMAL_SIZES = setOf(9, 16)
        private val NORMAL_NAME = Regex("norm", RegexOption.IGNORE_CASE)
        private val VIEW_NAME = Regex("view|cam", RegexOption.IGNORE_CASE)

        private fun products(matrices: List<Matrix4d>) = matrices.flatMap { a -> matrices.map { a.mul(it, Matrix4d()) } }

        private fun isNear(
            a: Matrix4dc,
            b: Matrix4dc,
        ): Boolean {
            val largest = (0..15).maxOf { abs(b.get(it / 4, it % 4)) }
            return (0..15).all { abs(a.get(it / 4, it % 4) - b.get(it / 4, it % 4)) <= 1e-5 * largest }
        }

        /** Whether [m] is a perspective projection along −z, up to the rounding of floats. */
        private fun isProjection(m: Matrix4dc): Boolean {
            val w = m.m23()
            if (!(abs(w) > 0) || !m.m00().isFinite()) return false
            val mustVanish = listOf(m.m03(), m.m13(), m.m33(), m.m01(), m.m02(), m.m10(), m.m12(), m.m30(), m.m31())
            return abs(w + 1) < 1e-3 && mustVanish.all { abs(it) < 1e-4 } && m.m00() != 0.0 && m.m11() != 0.0
        }
    }
}

/** Whether this matrix turns, moves and scales alike in all directions, and does nothing else, up to the rounding of floats. */
internal fun Matrix4dc.isEven(): Boolean {
    val scale = scale()
    val square = Matrix4d(this).setTranslation(0.0, 0.0, 0.0).let { it.mul(it.transpose(Matrix4d())) }

    fun isNear(
        i: Int,
        j: Int,
    ) = abs(square.get(i, j) - if (i == j) scale * scale else 0.0) < 1e-4 * scale * scale
    return scale > 0 && (0..2).all { i -> (0..2).all { j -> isNear(i, j) } } &&
        m03() == 0.0 && m13() == 0.0 && m23() == 0.0 && abs(m33() - 1) < 1e-9
}

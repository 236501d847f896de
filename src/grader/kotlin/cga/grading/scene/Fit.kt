package cga.grading.scene

import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.max

/** One observation that a linear model should explain: [value] = [offset] + Σ unknownᵢ · [columns]ᵢ. */
internal class Equation(val columns: List<Vector3dc>, val offset: Vector3dc, val value: Vector3dc) {
    /** The distance between [value] and what the model makes of [unknown]. */
    fun left(unknown: DoubleArray): Double {
        val said = Vector3d(offset)
        columns.forEachIndexed { i, column -> said.fma(unknown[i], column) }
        return said.distance(value)
    }
}

/** [matrix] · point = [value], for a point that is not known. */
internal fun equation(
    matrix: Matrix4dc,
    value: Vector3dc,
): Equation = Equation((0..2).map { matrix.column(it) }, matrix.translation(), value)

internal fun Matrix4dc.column(i: Int): Vector3d = Vector3d(get(i, 0), get(i, 1), get(i, 2))

/**
 * The constants that explain observations best.
 *
 * @param left the largest distance that they leave.
 */
internal class Fit(val constants: DoubleArray, val left: Double) {
    val point: Vector3d get() = Vector3d(constants)
}

/** Least squares for the unknowns of [equations], by their normal equations; null where these do not determine them. */
internal fun fit(equations: List<Equation>): Fit? {
    val size = equations.firstOrNull()?.columns?.size ?: return null
    val rows = Array(size) { i ->
        DoubleArray(size + 1) { j ->
            equations.sumOf { it.columns[i].dot(if (j < size) it.columns[j] else it.value.sub(it.offset, Vector3d())) }
        }
    }
    val constants = solved(rows) ?: return null
    return Fit(constants, equations.maxOf { it.left(constants) })
}

/** The solution of a system of linear equations, each row with its right side at its end; null where there is none, or more than one. */
private fun solved(rows: Array<DoubleArray>): DoubleArray? {
    val scale = rows.indices.maxOf { abs(rows[it][it]) }
    for (i in rows.indices) {
        val pivot = (i until rows.size).maxBy { abs(rows[it][i]) }
        rows[i] = rows[pivot].also { rows[pivot] = rows[i] }
        if (!(abs(rows[i][i]) > SINGULAR * scale)) return null
        for (row in rows.filter { it !== rows[i] }) {
            val factor = row[i] / rows[i][i]
            for (j in row.indices) row[j] -= factor * rows[i][j]
        }
    }
    return DoubleArray(rows.size) { rows[it].last() / rows[it][it] }.takeIf { all -> all.all(Double::isFinite) }
}

/** A hypothesis, the constant that fits it best, and the share of what is observed that is left then. */
internal class Tried<H>(val hypothesis: H, val constant: Vector3d, val residual: Double)

/**
 * Hypotheses that were tried on the same observations, the simplest first.
 *
 * @param tolerance the residual up to which one holds.
 */
internal class Trial<H>(val all: List<Tried<H>>, private val tolerance: Double) {
    /** Those that nothing observed contradicts; several are a tie. */
    val holding: List<Tried<H>> = all.filter { it.residual <= tolerance }

    /** The one that leaves least, whether it holds or not. */
    val nearest: Tried<H>? = all.minByOrNull { it.residual }

    /** What [hypothesis] leaves; 1 where it could not be tried. */
    fun residual(hypothesis: H): Double = all.find { it.hypothesis == hypothesis }?.residual ?: 1.0
}

/** Tries which of [hypotheses] explains [samples], points or directions with what they were observed in: matrix · constant = value. */
internal fun <H, S> tryAll(
    hypotheses: List<H>,
    samples: List<Pair<S, Vector3dc>>,
    tolerance: Double,
    matrix: (H, S) -> Matrix4dc,
): Trial<H> {
    // A light may be at the camera: then what is left is measured in whole units.
    val reach = max(samples.sumOf { (_, value) -> value.length() } / max(1, samples.size), LEAST_REACH)
    val tried = hypotheses.mapNotNull { hypothesis ->
        val fit = fit(samples.map { (where, value) -> equation(matrix(hypothesis, where), value) })
        fit?.let { Tried(hypothesis, it.point, it.left / reach) }
    }
    return Trial(tried, tolerance)
}

/** Relative to the largest coefficient. */
private const val SINGULAR = 1e-12

/** World units. */
private const val LEAST_REACH = 0.1

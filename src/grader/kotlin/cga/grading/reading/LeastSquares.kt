package cga.grading.reading

import kotlin.math.abs
import kotlin.math.sqrt

/** Exact linear relations: fits by least squares, of which only those count that leave nothing. [rows] have one number for each unknown. */
internal class LeastSquares(private val rows: List<DoubleArray>) {
    private val unknowns = rows.first().size

    /** The numbers x with rows · x = [values] to 1 part in [precision]; null where there are none. */
    fun solve(values: DoubleArray, precision: Double = EXACT): DoubleArray? {
        val x = best(values) ?: return null
        val size = sqrt(values.sumOf { it * it } / values.size)
        val worst = rows.indices.maxOf { i -> abs(values[i] - rows[i].indices.sumOf { rows[i][it] * x[it] }) }
        return x.takeIf { worst <= precision * (size + 1e-3) }
    }

    /** The numbers x with the least |rows · x − values|²; null where they are not determined. */
    fun best(values: DoubleArray): DoubleArray? {
        val matrix = Array(unknowns) { i ->
            DoubleArray(unknowns + 1) { j ->
                if (j <
                    unknowns
                ) {
                    rows.sumOf { it[i] * it[j] }
                } else {
                    rows.indices.sumOf { rows[it][i] * values[it] }
                }
            }
        }
        for (column in 0 until unknowns) {
            val pivot = (column until unknowns).maxBy { abs(matrix[it][column]) }
            if (!(abs(matrix[pivot][column]) > 1e-13)) return null
            matrix[column] = matrix[pivot].also { matrix[pivot] = matrix[column] }
            for (row in 0 until unknowns) {
                if (row == column) continue
                val factor = matrix[row][column] / matrix[column][column]
                for (k in column..unknowns) matrix[row][k] -= factor * matrix[column][k]
            }
        }
        return DoubleArray(unknowns) { matrix[it][unknowns] / matrix[it][it] }
    }

    private companion object {
        const val EXACT = 1e-9
    }
}

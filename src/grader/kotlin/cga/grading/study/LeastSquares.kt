package cga.grading.study

import kotlin.math.abs

/**
 * Weighted linear least squares by the normal equations: few unknowns, many rows.
 *
 * Columns are scaled to equal lengths before solving, so that unknowns of very different size do no harm.
 */
internal class LeastSquares(private val unknowns: Int) {
    private val matrix = Array(unknowns) { DoubleArray(unknowns) }
    private val right = DoubleArray(unknowns)
    private var rows = 0

    /** One equation: [coefficients] · x = [value]. */
    fun add(
        coefficients: DoubleArray,
        value: Double,
        weight: Double = 1.0,
    ) {
        if (!value.isFinite() || coefficients.any { !it.isFinite() }) return
        rows++
        for (i in 0 until unknowns) {
            for (j in 0 until unknowns) matrix[i][j] += weight * coefficients[i] * coefficients[j]
            right[i] += weight * coefficients[i] * value
        }
    }

    /** The unknowns, or null where the equations do not settle them. */
    fun solve(): DoubleArray? {
        if (rows < unknowns) return null
        val scale = DoubleArray(unknowns) { if (matrix[it][it] > 0) 1 / Math.sqrt(matrix[it][it]) else return null }
        val a = Array(unknowns) { i ->
            DoubleArray(unknowns + 1) { j ->
                if (j ==
                    unknowns
                ) {
                    right[i] * scale[i]
                } else {
                    matrix[i][j] * scale[i] * scale[j]
                }
            }
        }
        for (column in 0 until unknowns) {
            val pivot = (column until unknowns).maxBy { abs(a[it][column]) }
            if (abs(a[pivot][column]) < SINGULAR) return null
            val swapped = a[pivot]
            a[pivot] = a[column]
            a[column] = swapped
            for (row in 0 until unknowns) {
                if (row == column) continue
                val factor = a[row][column] / a[column][column]
                for (j in column..unknowns) a[row][j] -= factor * a[column][j]
            }
        }
        return DoubleArray(unknowns) { a[it][unknowns] / a[it][it] * scale[it] }
    }

    private companion object {
        const val SINGULAR = 1e-11
    }
}

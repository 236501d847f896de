package cga.measure.accuracy

import kotlin.math.abs

/**
 * Errors of one operation, counted in ulps of a float *of the largest number in the column*.
 *
 * A matrix's column is where an axis goes, and the last one where the origin goes: an error matters as a displacement of that vector,
 * in proportion to its length. An ulp of the number itself would ask too much: beside a 1, a cosine of −4.4e-8 that came out as 0 is
 * off by less than half an ulp of the vector, and by 100 % of itself. An ulp of the matrix's largest number would ask too little:
 * columns have units of their own, and a position of 1e6 would hide any error of the axes, a scale of 1e13 the axis beside it.
 *
 * A correctly rounded float is at most 0.5 off.
 */
internal class Errors(private val operation: Operation) {
    private var cases = 0
    private var notFinite = 0
    private var numbers = 0
    private var sum = 0.0
    private var maxUlp = 0.0
    private var maxRelative = 0.0

    /** Counts what is [computed], by columns, where [truth] is right. */
    fun add(
        truth: DoubleArray,
        computed: DoubleArray,
    ) {
        cases++
        // Of a normal matrix only the direction counts.
        if (operation == Operation.NORMAL_MATRIX) compare(toUnit(truth), toUnit(computed)) else compare(truth, computed)
    }

    fun figure(
        kind: String,
        implementation: String,
        options: String,
    ): Figure {
        fun known(value: Double) = if (numbers > 0) value else Double.NaN
        return Figure(operation, kind, implementation, options, cases, notFinite, known(maxUlp), known(sum / numbers), known(maxRelative))
    }

    private fun compare(
        truth: DoubleArray,
        computed: DoubleArray,
    ) {
        if (!computed.all(Double::isFinite)) {
            notFinite++
            return
        }
        val rows = ROWS.getValue(truth.size)
        val largest = largest(truth, truth.indices)
        for (i in truth.indices) {
            val column = i - i % rows
            val error = abs(computed[i] - truth[i])
            val ulps = error / floatUlp(largest(truth, column until column + rows))
            numbers++
            sum += ulps
            maxUlp = maxOf(maxUlp, ulps)
            maxRelative = maxOf(maxRelative, error / largest)
        }
    }

    private fun largest(
        numbers: DoubleArray,
        indices: IntRange,
    ): Double = maxOf(indices.maxOf { abs(numbers[it]) }, operation.floor)

    private fun toUnit(matrix: DoubleArray): DoubleArray {
        val largest = matrix.maxOf { abs(it) }
        return DoubleArray(matrix.size) { matrix[it] / largest }
    }

    private companion object {
        /** By the count of numbers: a factor, a 3×3 and a 4×4 matrix. */
        val ROWS = mapOf(1 to 1, 9 to 3, 16 to 4)

        /** The step between floats from [x] on. */
        fun floatUlp(x: Double): Double = Math.scalb(1.0, maxOf(Math.getExponent(x) - 23, -149))
    }
}

package cga.measure.accuracy

import cga.testing.FLOAT_ROUNDING
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.Double.Companion.NEGATIVE_INFINITY
import kotlin.Double.Companion.NaN

class ErrorsTest {
    private val identity = DoubleArray(16) { if (it % 5 == 0) 1.0 else 0.0 }

    @Test
    fun `what is right has no error`() {
        val figure = figure(Operation.PLACING, identity, identity)
        assertEquals(Figure(Operation.PLACING, "kind", "someone", "", 1, 0, 0.0, 0.0, 0.0), figure)
    }

    @Test
    fun `an error counts in ulps of the largest number in its column`() {
        val truth = identity.copyOf().also { it[12] = 1e6 }
        val beside1 = truth.copyOf().also { it[1] += FLOAT_ROUNDING }
        assertEquals(0.5, figure(Operation.PLACING, truth, beside1).maxUlp)
        val beside1e6 = truth.copyOf().also { it[13] += FLOAT_ROUNDING }
        assertEquals(FLOAT_ROUNDING / Math.ulp(1e6f), figure(Operation.PLACING, truth, beside1e6).maxUlp)
        assertEquals(FLOAT_ROUNDING / Math.ulp(1e6f) / 16, figure(Operation.PLACING, truth, beside1e6).meanUlp)
        assertEquals(FLOAT_ROUNDING / 1e6, figure(Operation.PLACING, truth, beside1).maxRelative)
    }

    @Test
    fun `a rounded float is off by half an ulp at most`() {
        val truth = DoubleArray(16) { 1 + it * 0.7310585786300049 }
        val figure = figure(Operation.PLACING, truth, DoubleArray(16) { truth[it].toFloat().toDouble() })
        assertTrue(figure.maxUlp in 0.25..0.5) { "$figure" }
    }

    @Test
    fun `factors count in ulps of 1`() {
        assertEquals(1.0, figure(Operation.CONE_OF_VERSINES, doubleArrayOf(1e-6), doubleArrayOf(1e-6 + Math.ulp(1f))).maxUlp, 1e-6)
    }

    @Test
    fun `a normal matrix may have any size, but not the other sign`() {
        val truth = DoubleArray(9) { if (it % 4 == 0) 1.0 else 0.0 }
        assertEquals(0.0, figure(Operation.NORMAL_MATRIX, truth, DoubleArray(9) { 8 * truth[it] }).maxUlp)
        assertEquals(2.0, figure(Operation.NORMAL_MATRIX, truth, DoubleArray(9) { -truth[it] }).maxRelative)
    }

    @Test
    fun `what is not finite is counted and left out`() {
        val errors = Errors(Operation.PLACING)
        for (bad in listOf(NaN, NEGATIVE_INFINITY)) errors.add(identity, identity.copyOf().also { it[3] = bad })
        assertEquals(Figure(Operation.PLACING, "kind", "someone", "", 2, 2, NaN, NaN, NaN), errors.figure("kind", "someone", ""))
        errors.add(identity, identity)
        assertEquals(Figure(Operation.PLACING, "kind", "someone", "", 3, 2, 0.0, 0.0, 0.0), errors.figure("kind", "someone", ""))
    }

    private fun figure(
        operation: Operation,
        truth: DoubleArray,
        computed: DoubleArray,
    ) = Errors(operation).apply { add(truth, computed) }.figure("kind", "someone", "")
}

package cga.grading.study

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

class LeastSquaresTest {
    @Test
    fun `a line through points of very different size is found`() {
        val equations = LeastSquares(2)
        for (i in 0..9) equations.add(doubleArrayOf(1e6 * i, 1.0), 3e-6 * (1e6 * i) + 2.0)
        val (slope, offset) = equations.solve() ?: error("no solution")
        // Condition after scaling is below 10, so a few roundings of doubles are left.
        assertEquals(3e-6, slope, 3e-6 * 1e-12)
        assertEquals(2.0, offset, 1e-12 * 10)
    }

    @Test
    fun `the heavier of two contradicting rows counts more`() {
        val equations = LeastSquares(1)
        equations.add(doubleArrayOf(1.0), 0.0)
        equations.add(doubleArrayOf(1.0), 4.0, weight = 3.0)
        assertEquals(3.0, equations.solve()?.get(0) ?: error("no solution"), 1e-12)
    }

    @Test
    fun `rows that are no numbers are left out and too few settle nothing`() {
        val equations = LeastSquares(2)
        equations.add(doubleArrayOf(1.0, 0.0), 1.0)
        equations.add(doubleArrayOf(Double.NaN, 1.0), 1.0)
        equations.add(doubleArrayOf(0.0, 1.0), Double.POSITIVE_INFINITY)
        assertNull(equations.solve())
    }

    @Test
    fun `equal rows settle nothing`() {
        val equations = LeastSquares(2)
        repeat(3) { equations.add(doubleArrayOf(1.0, 2.0), 5.0) }
        assertNull(equations.solve())
    }
}

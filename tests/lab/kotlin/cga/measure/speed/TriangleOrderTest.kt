package cga.measure.speed

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TriangleOrderTest {
    /** Two triangles a cell of a grid, row after row. */
    private val grid =
        (0 until SIDE * SIDE)
            .flatMap { cell ->
                val corner = cell / SIDE * (SIDE + 1) + cell % SIDE
                listOf(corner, corner + 1, corner + SIDE + 1, corner + 1, corner + SIDE + 2, corner + SIDE + 1)
            }.toIntArray()

    @Test
    fun `every order has all triangles, each as it was`() {
        for (order in listOf(TriangleOrder.forCache(grid), TriangleOrder.shuffled(grid))) assertEquals(triangles(grid), triangles(order))
    }

    @Test
    fun `separate triangles miss with all their vertices, one again and again with three`() {
        assertEquals(3.0, TriangleOrder.cacheMisses(IntArray(300) { it }))
        assertEquals(0.03, TriangleOrder.cacheMisses(IntArray(300) { it % 3 }))
    }

    /** Row after row of a grid wider than the cache shades each vertex twice, one a triangle; fans come near the 0.5 of a triangle strip's best. */
    @Test
    fun `fans use the cache better than rows, and no order is worse than none`() {
        val rows = TriangleOrder.cacheMisses(grid)
        assertEquals(1.0, rows, 0.05)
        assertTrue(TriangleOrder.cacheMisses(TriangleOrder.forCache(grid)) < 0.75 * rows)
        assertTrue(TriangleOrder.cacheMisses(TriangleOrder.shuffled(grid)) > 2 * rows)
    }

    private fun triangles(indices: IntArray) = indices.toList().chunked(3).sortedWith(compareBy({ it[0] }, { it[1] }, { it[2] }))

    private companion object {
        const val SIDE = 60
    }
}

package cga.measure.accuracy.choices

import cga.measure.Sample
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ParetoTest {
    @Test
    fun `the front holds those that nothing else beats in both`() {
        val rows = listOf(row("slow", 9.0, 0.1), row("beaten", 5.0, 2.0), row("fast", 1.0, 8.0), row("middle", 5.0, 1.0))
        assertEquals(listOf("fast", "middle", "slow"), Pareto.front(rows).map { it.name })
    }

    @Test
    fun `of two that are the same one is on the front`() {
        assertEquals(listOf("a"), Pareto.front(listOf(row("a", 1.0, 1.0), row("b", 1.0, 1.0))).map { it.name })
    }

    @Test
    fun `what is slower and no nearer is not on the front`() {
        assertEquals(listOf("a"), Pareto.front(listOf(row("a", 1.0, 1.0), row("b", 2.0, 1.0))).map { it.name })
    }

    @Test
    fun `the front is by the error that is asked for`() {
        val rows = listOf(Measured("a", Sample(listOf(1.0)), 9.0, 1.0), Measured("b", Sample(listOf(2.0)), 5.0, 2.0))
        assertEquals(listOf("a"), Pareto.front(rows).map { it.name })
        assertEquals(listOf("a", "b"), Pareto.front(rows, Measured::max).map { it.name })
    }

    @Test
    fun `costs whose spreads overlap are the same`() {
        val near = Measured("near", Sample(listOf(2.0, 3.0)), 1.0, 1.0)
        assertEquals(listOf("near"), Pareto.front(listOf(Measured("far", Sample(listOf(1.0, 2.5)), 2.0, 2.0), near)).map { it.name })
        assertEquals(
            listOf("far", "near"),
            Pareto.front(listOf(Measured("far", Sample(listOf(1.0, 1.5)), 2.0, 2.0), near)).map { it.name },
        )
    }

    @Test
    fun `only choices that draw the same are compared`() {
        val phong = Measured("Phong", Sample(listOf(0.5)), 0.1, 0.1, "Phong")
        val others = listOf(1.0 to 2.0, 2.0 to 1.0).map { (cost, error) -> Measured("$cost", Sample(listOf(cost)), error, error) }
        assertEquals(listOf("1.0", "2.0"), Pareto.front(others + phong).map { it.name })
    }

    @Test
    fun `a group is a table with the front marked and median, lowest and highest cost`() {
        val rows = listOf(Measured("good", Sample(listOf(3.0, 1.0, 2.0)), 0.5, 0.25), row("bad", 4.0, 1.0))
        val lines = MeasuredGroup("Title", "Note.", "ms", "1/255", rows).toMarkdown().lines()
        assertEquals("#### Title", lines[0])
        assertTrue("| good | 2.00 | 1.00 – 3.00 | 0.500 | 0.250 | ● |" in lines) { lines.joinToString("\n") }
        assertTrue("| bad | 4.00 | 4.00 – 4.00 | 1.00 | 1.00 |  |" in lines) { lines.joinToString("\n") }
    }

    private fun row(
        name: String,
        cost: Double,
        error: Double,
    ) = Measured(name, Sample(listOf(cost)), error, error)
}

package cga.inspect.soak

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.exp
import kotlin.random.Random

/** The verdict on made-up soaks of ten minutes, 41 looks each. */
class FlatnessTest {
    private val random = Random(11)

    @Test
    fun `what breathes but stays is flat`() {
        repeat(50) { assertEquals(emptyList<String>(), Flatness.growth(looks({ 300 + random.nextDouble(-20.0, 20.0) }))) }
        assertEquals(emptyList<String>(), Flatness.growth(looks({ 300.0 })))
    }

    @Test
    fun `a warm-up is flat when it ends within the first half`() {
        assertEquals(emptyList<String>(), Flatness.growth(looks({ 200 + 5.0 * minOf(it, 20) }, { minOf(50 + it, 70) })))
        // A minute's half-life.
        assertEquals(emptyList<String>(), Flatness.growth(looks({ 300 - 100 * exp(-it / 5.8) + random.nextDouble(-3.0, 3.0) })))
    }

    @Test
    fun `a single jump is flat`() {
        assertEquals(emptyList<String>(), Flatness.growth(looks({ if (it < 25) 200.0 else 230.0 })))
    }

    @Test
    fun `a leak is growth, in resident memory, heap or objects, each by its name`() {
        // 2 MiB a minute, in noise of 6 MiB.
        val resident = Flatness.growth(looks({ 300 + 0.5 * it + random.nextDouble(-3.0, 3.0) }))
        assertTrue(resident.single().startsWith("resident memory grew: "), "$resident")
        val live = Flatness.growth(looks({ 300.0 }, live = { 20 + 0.2 * it }))
        assertEquals(listOf("live heap grew: 0.80 ± 0.00 MiB a minute"), live)
        val objects = Flatness.growth(looks({ 300.0 }, { 60 + it / 4 }))
        assertTrue(objects.single().startsWith("OpenGL objects grew: "), "$objects")
    }

    @Test
    fun `a leak that is still within the allowance is not told from caches`() {
        val perLook = Flatness.RESIDENT / 40
        assertEquals(emptyList<String>(), Flatness.growth(looks({ 300 + 0.9 * perLook * it })))
        assertEquals(1, Flatness.growth(looks({ 300 + 2 * perLook * it })).size)
    }

    @Test
    fun `few looks tell nothing`() {
        assertTrue("too few looks" in Flatness.growth(looks({ 300.0 }).take(8)).single())
    }

    @Test
    fun `a trend is the median slope, and its limits are further apart the more the points scatter`() {
        val x = DoubleArray(30) { it.toDouble() }
        val line = Trend.of(x, DoubleArray(30) { 3.0 * it })
        assertEquals(listOf(3.0, 3.0, 3.0), listOf(line.low, line.slope, line.high))
        // 29 % of the points anywhere: here 8 of 30.
        val broken = Trend.of(x, DoubleArray(30) { if (it % 4 == 1) 1000.0 else 3.0 * it })
        assertEquals(3.0, broken.slope)
        val noisy = Trend.of(x, DoubleArray(30) { 3.0 * it + random.nextDouble(-10.0, 10.0) })
        assertTrue(noisy.low < 3.0 && 3.0 < noisy.high && noisy.high - noisy.low > 0.1) { "${noisy.low} ${noisy.high}" }
    }

    private fun looks(
        resident: (Int) -> Double,
        objects: (Int) -> Int = { 72 },
        live: (Int) -> Double = { 25.0 },
    ) = List(41) { Held(15.0 * it, 100 * it, resident(it), live(it), objects(it)) }
}

package cga.measure.accuracy.choices

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class PictureErrorTest {
    @Test
    fun `the worst channel counts, as a screen shows it`() {
        // Off by 0.25 in blue; both beyond 1, which a screen shows alike; not compared.
        val truth = doubleArrayOf(0.5, 0.5, 0.5, 3.0, 1.0, 1.0, 0.0, 0.0, 0.0)
        val drawn = floatArrayOf(0.5f, 0.5f, 0.75f, 1f, 2f, 1f, 1f, 1f, 1f, 1f, 1f, 1f)
        val error = PictureError.of(truth, drawn) { it < 2 }
        assertEquals(0.25 * 255, error.max)
        assertEquals(0.125 * 255, error.mean)
    }

    @Test
    fun `alpha is no colour`() {
        assertEquals(0.0, PictureError.of(doubleArrayOf(0.0, 0.0, 0.0), floatArrayOf(0f, 0f, 0f, 0.5f)) { true }.max)
    }
}

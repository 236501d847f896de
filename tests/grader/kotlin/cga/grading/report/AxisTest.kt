package cga.grading.report

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

class AxisTest {
    @Test
    fun `ticks are round and hold all values`() {
        assertEquals(listOf(0.0, 0.2, 0.4, 0.6, 0.8, 1.0), Axis.over(listOf(0.03, 0.97), 0, 100).ticks.map { Math.round(it * 1e9) / 1e9 })
    }

    @ParameterizedTest
    @CsvSource("0, 0", "5, 5", "-1e300, 1e300", "0, 1e-300", "1e9, 1000000001", "-3, 0.001", "0, 1.7976931348623157e308")
    fun `every value has a place between the ends`(least: Double, most: Double) {
        val axis = Axis.over(listOf(least, most), 10, 110)
        for (value in listOf(
            least,
            most,
        ).map { it.coerceIn(-1e300, 1e300) }) {
            assertTrue(axis.at(value) in 9.99..110.01) { "${axis.at(value)}" }
        }
        assertTrue(axis.ticks.size in 2..9) { "${axis.ticks}" }
    }
}

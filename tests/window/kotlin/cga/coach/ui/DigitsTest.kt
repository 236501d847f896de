package cga.coach.ui

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class DigitsTest {
    @Test
    fun `numbers have the digits that they need`() {
        val digits = Digits()
        val texts =
            mapOf(0.01f to "0.01", 0.9f to "0.9", 16f to "16", 0f to "0", -0.35f to "-0.35", 0.0001f to "0.0001", 1f / 3 to "0.3333")
        for ((number, text) in texts + mapOf(12345.6f to "12350", 1e-9f to "1.00e-09", Float.NaN to "NaN")) {
            assertEquals(text, digits.of(number))
            assertEquals(text, digits.of(number), "the second time")
        }
    }
}

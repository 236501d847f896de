package cga.imaging.flip

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ColorSpaceTest {
    @Test
    fun `the cube root is as good as floats allow`() {
        var value = 0.008f
        while (value < 1.01f) {
            val exact = Math.cbrt(value.toDouble())
            assertEquals(exact, ColorSpace.cubeRoot(value).toDouble(), 3e-7 * exact)
            value *= 1.0001f
        }
    }

    @Test
    fun `white is 100, 0, 0 and black is 0, 0, 0 on the way there and back`() {
        val row = ColorRow(2)
        for (channel in listOf(row.first, row.second, row.third)) channel[0] = 1f
        ColorSpace.linearToOpponent(row)
        assertEquals(listOf(1f, 0f, 0f), listOf(row.first[0], row.second[0], row.third[0]).map { Math.round(it * 1e6f) / 1e6f })
        ColorSpace.opponentToHuntLab(row)
        // The reference's matrices and white point agree to six digits; a and b are 500 and 200 times a difference of cube roots.
        assertEquals(100f, row.first[0], 1e-3f)
        for (rest in listOf(row.second[0], row.third[0], row.first[1], row.second[1], row.third[1])) assertEquals(0f, rest, 1e-3f)
    }
}

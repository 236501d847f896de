package cga.imaging.flip

import cga.testing.assertRefused
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class FlipMapTest {
    @Test
    fun `a percentile is the error that so many pixels do not exceed`() {
        val map = FlipMap(5, 2, FloatArray(10) { (9 - it) / 10f })
        assertEquals(listOf(0f, 0f, 0.4f, 0.5f, 0.9f), listOf(0.0, 0.1, 0.5, 0.51, 1.0).map(map::percentile))
        assertRefused(1.5) { map.percentile(1.5) }
        assertRefused(Double.NaN) { map.percentile(Double.NaN) }
    }

    @Test
    fun `a mean does not lose small errors beside a large one`() {
        // In float each of them would be rounded away.
        assertEquals(1.0 / 1001 + 1e-8 * 1000 / 1001, FlipMap(1001, 1, FloatArray(1001) { if (it == 0) 1f else 1e-8f }).mean, 1e-14)
    }

    @Test
    fun `a map is drawn in the colours of NVIDIA's implementation`() {
        val errors = FloatArray(256) { it / 255f }
        val picture = FlipMap(64, 4, errors).magma()
        val colors = picture.rgba.asList().chunked(4) { (r, g, b) -> "%02x%02x%02x".format(r, g, b) }
        assertEquals(FlipPair.magma(), colors)
        assertEquals(listOf(64, 4, 256), listOf(picture.width, picture.height, picture.rgba.count { it == (-1).toByte() }))
    }
}

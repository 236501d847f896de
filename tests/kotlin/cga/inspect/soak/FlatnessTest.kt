package cga.inspect.soak

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class FlatnessTest {
    @Test
    fun `what is made at the start and then stays is flat, however the heap breathes`() {
        assertNull(Flatness.growth(looks({ 200.0 + 10 * minOf(it, 8) + 15 * (it % 3) }, { minOf(50 + 10 * it, 90) })))
    }

    @Test
    fun `an object a look is growth, and so is memory`() {
        assertTrue("OpenGL objects" in Flatness.growth(looks({ 200.0 }, { 100 + it })).orEmpty())
        assertTrue("memory" in Flatness.growth(looks({ 200.0 + 12 * it }, { 100 })).orEmpty())
    }

    @Test
    fun `a single look tells nothing`() {
        assertNotNull(Flatness.growth(looks({ 200.0 }, { 100 }).take(1)))
        assertEquals(null, Flatness.growth(looks({ 200.0 }, { 100 })))
    }

    private fun looks(mebibytes: (Int) -> Double, objects: (Int) -> Int) = List(
        20,
    ) { Held(30.0 * it, 100 * it, mebibytes(it), objects(it)) }
}

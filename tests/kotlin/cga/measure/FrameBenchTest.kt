package cga.measure

import cga.exercise.game.Step
import cga.framework.context.ContextKind
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class FrameBenchTest {
    @Test
    fun `after the warm-up a frame allocates nothing`() {
        Offscreen.openOrSkip(ContextKind.OSMESA).close()
        val result = FrameBench.measure(ContextKind.OSMESA, 61, Step.FINAL, 160, 90)
        // The median: now and then the JIT compiler allocates on the thread that it takes over.
        assertEquals(0.0, result.bytes.median)
        assertTrue(result.milliseconds.lowest > 0.0)
        assertTrue(result.renderer.isNotEmpty())
    }

    @Test
    fun `a sample knows its middle and its ends`() {
        val sample = Sample(listOf(5.0, 1.0, 3.0))
        assertEquals(listOf(1.0, 3.0, 5.0), listOf(sample.lowest, sample.median, sample.highest))
    }
}

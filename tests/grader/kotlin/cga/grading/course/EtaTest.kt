package cga.grading.course

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.random.Random

class EtaTest {
    private fun eta(jobs: Int, vararg times: Double) = Eta(jobs).apply { times.forEach(::add) }

    @Test
    fun `too few times say nothing`() {
        assertNull(eta(1, 1.0, 2.0).seconds(10))
        assertEquals("time left not known yet", eta(1).words(10))
    }

    @Test
    fun `equal times give one number, shared among the workers`() {
        assertEquals(50.0..50.0, eta(2, 5.0, 5.0, 5.0).seconds(20))
        assertEquals("50 s left", eta(2, 5.0, 5.0, 5.0).words(20))
        assertEquals("10 min left", eta(1, 6.0, 6.0, 6.0).words(100))
        assertEquals("0 s left", eta(1, 6.0, 6.0, 6.0).words(0))
    }

    @Test
    fun `the last submission has no two workers`() {
        assertEquals(5.0, eta(8, 5.0, 5.0, 5.0).seconds(1)?.start)
    }

    @Test
    fun `the truth lies in the range most of the time, though one in ten takes ten times as long`() {
        val random = Random(3)
        var inside = 0
        repeat(400) {
            fun time() = if (random.nextInt(10) == 0) 60.0 else 4 + 2 * random.nextDouble()
            val eta = Eta(1).apply { repeat(40) { add(time()) } }
            val rest = List(60) { time() }.sum()
            if (rest in eta.seconds(60)!!) inside++
        }
        // Two standard deviations: 95 % for sums of many; the times are skewed and their variance is estimated, so somewhat fewer.
        assertTrue(inside > 340) { "$inside of 400" }
    }
}

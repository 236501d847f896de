package cga.measure.accuracy.hard

import cga.exercise.components.light.PointLight
import cga.framework.SpecularModel
import cga.testing.Offscreen
import cga.testing.Slow
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import kotlin.random.Random

@Slow
class SearchTest {
    @Test
    fun `no point of the domain gives NaN or infinity, or errs by more than floats do`() {
        val result = HardCases.search(100_000, SEED)
        assertEquals(listOf(0, 0), listOf(result.notFinite, result.beyondBound)) { result.findings.joinToString("\n") }
        assertTrue(result.compared > result.evaluations / 3) { "$result" }
        // Were the bounds much too wide, nothing would come near them.
        assertTrue(result.worst > 0.1) { "$result" }
    }

    @Test
    fun `the same seed gives the same points`() {
        fun positions(seed: Long) = RandomShots(Random(seed)).run { List(100) { next().position } }
        assertEquals(positions(3), positions(3))
        assertNotEquals(positions(3), positions(4))
    }

    @Test
    fun `points at the limits come up`() {
        val shots = RandomShots(Random(SEED)).run { List(2_000) { next() } }
        assertTrue(shots.any { it.normal.length() == 0f })
        assertTrue(shots.any { shot -> shot.lights.any { it.getWorldPosition() == shot.position } })
        assertTrue(shots.any { shot -> shot.truth().lights.any { it.distance > 1.85e19 } })
        assertTrue(shots.any { it.k == 0f } && shots.any { it.k > 1e38f })
        assertEquals(SpecularModel.entries.toSet(), shots.map { it.specularModel }.toSet())
    }

    @Test
    fun `what would not be finite is refused`() {
        assertThrows(IllegalArgumentException::class.java) { PointLight(Vector3f(), Vector3f(0f, -1.1e18f, 0f)) }
        assertEquals(1e18f, PointLight(Vector3f(), Vector3f(1e18f)).lightColor.x())
    }

    companion object {
        private const val SEED = 1L

        @BeforeAll
        @JvmStatic
        fun `OpenGL is there`() {
            Offscreen.openOrSkip().close()
        }
    }
}

package cga.measure.accuracy.hard

import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/** The naive form, ours and the truth, case by case. Where the bounds come from stands beside each case and in [Rounding]. */
class HardCasesTest {
    @TestFactory
    fun `ours keeps its bound, and the naive form fails where the table says so`(): List<DynamicTest> =
        cases.map { case ->
            dynamicTest("${case.name}: ${case.naive} against ${case.ours}") {
                assertTrue(case.ourError <= case.bound) { "$case" }
                assertEquals(case.failure.isNotEmpty(), case.naiveFails) { "$case" }
            }
        }

    @Test
    fun `the narrowest cone errs by less than 8 of 255 and by 255 in cosines`() {
        val cones = ConeCases.DEGREES.zip(cases).toMap()
        val narrowest = cones.getValue(0.001)
        assertTrue(narrowest.bound < 8) { "$narrowest" }
        assertEquals(255.0, narrowest.naiveError, 0.001)
        for (degrees in listOf(90.0, 30.0, 1.0, 0.1, 0.01)) assertTrue(cones.getValue(degrees).bound < 1) { "$degrees°" }
    }

    @Test
    fun `the course's way loses the scene with the distance, ours nowhere`() {
        val scenes = named("scene ")
        assertEquals(8, scenes.size)
        val ours = scenes.map { it.ourError }
        assertTrue(ours.max() < 0.01) { "$ours" }
        // A float's step at a distance D is up to 2⁻²³·D, and the camera's, the light's and the model's share of it differ.
        val naive = scenes.map { it.naiveError }
        assertTrue(naive[7] > 1e3 * naive[1]) { "$naive" }
    }

    @Test
    fun `every number in the table is there, one row a case`() {
        val lines = HardCases.table(cases).trimEnd().lines()
        assertEquals(cases.size + 2, lines.size)
        assertEquals(setOf(lines[0].count { it == '|' }), lines.map { line -> line.replace("\\|", "").count { it == '|' } }.toSet())
        assertEquals(cases.size, cases.map { it.name + it.naive }.distinct().size)
    }

    private fun named(start: String) = cases.filter { it.name.startsWith(start) }

    companion object {
        private lateinit var cases: List<HardCase>

        @BeforeAll
        @JvmStatic
        fun `all is measured`() {
            Offscreen.openOrSkip().close()
            cases = HardCases.measure()
        }
    }
}

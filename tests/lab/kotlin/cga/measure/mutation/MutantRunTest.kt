package cga.measure.mutation

import cga.framework.Home
import cga.framework.InputError
import cga.imaging.Severity
import cga.imaging.golden.GoldenStore
import cga.imaging.tolerance.Tolerance
import cga.measure.golden.GoldenCases
import cga.measure.golden.GoldenRun
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import org.junit.jupiter.api.extension.ExtendWith

/** The short form of `./cga golden mutants`: a few defects, on two cases, with the tolerance that the goldens have. */
@ExtendWith(Offscreen::class)
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class MutantRunTest {
    private val cases = GoldenCases.all.filter { it.name in setOf("step-4.7", "switch-float") }
    private val tolerance = Tolerance.read(Home.resolve("${GoldenRun.FOLDER}/${GoldenStore.TOLERANCE}"), "llvmpipe")

    private fun run(vararg names: String) = MutantRun(names.map(Mutants::of), cases, tolerance)

    @Test
    fun `defects that a person sees fail the tolerant tier too`() {
        val run =
            run(
                "point lights 5 % brighter",
                "cone's inner and outer angle swapped",
                "normal not normalised",
                "one triangle of the ground missing",
                "half a pixel to the right",
                "gamma where none is wanted",
                "mirrored",
                "8×8 pixels of the sky 16/255 brighter",
            )
        for (result in run.results()) {
            val name = result.mutant.name
            assertEquals(cases.size, result.visibleIn, "$name is visible")
            assertEquals(cases.size, result.failsExactIn, "$name fails the exact tier")
            assertTrue(result.failsTolerantIn > 0, "$name fails the tolerant tier")
        }
    }

    @Test
    fun `a single white pixel fails the tolerant tier`() {
        val result = run("one white pixel in the sky").results().single()
        assertEquals(0, result.visibleIn, "one pixel is less than 16")
        assertEquals(cases.size, result.failsTolerantIn)
    }

    @Test
    fun `scattered pixels that nobody sees pass the tolerant tier and count as visible all the same`() {
        val result = run("one pixel of 1000 1/255 brighter").results().single()
        assertEquals(listOf(cases.size, cases.size), listOf(result.visibleIn, result.failsExactIn))
        assertEquals(Severity.PASS, result.cases.single { !it.case.float }.verdict)
    }

    @Test
    fun `what changes nothing is no difference`() {
        assertEquals(listOf(0, 0), run("alpha of one half", "gamma missing").results().map { it.failsExactIn })
    }

    @Test
    fun `a mutant leaves nothing behind`() {
        val spoilt = listOf("no depth test", "front faces culled", "ambient light 0.01 added", "gamma where none is wanted")
        val results = run(*spoilt.flatMap { listOf(it, "alpha of one half") }.toTypedArray()).results()
        assertEquals(spoilt.flatMap { listOf(cases.size, 0) }, results.map { it.failsExactIn })
    }

    @Test
    fun `another process draws the same`() {
        val again = run().result(Renderer("the same again", emptyMap()))
        assertEquals(listOf(true, true), again.cases.map { it.isIdentical })
    }

    @Test
    fun `a renderer that does not start is an error that names it and says why`() {
        val broken = Renderer("broken", mapOf("JAVA_TOOL_OPTIONS" to "-XX:NoSuchOption"))
        val error = assertThrows(InputError::class.java) { run().result(broken) }
        assertTrue(error.message.orEmpty().startsWith("the renderer \"broken\" ended with exit code "), error.message)
        assertTrue("NoSuchOption" in error.message.orEmpty(), error.message)
    }
}

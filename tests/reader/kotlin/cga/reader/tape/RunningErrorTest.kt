package cga.reader.tape

import cga.reader.fragment
import cga.reader.run.Machine
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** That the bounds hold is what the comparisons with Mesa show; here is that they are bounds of what they should be. */
class RunningErrorTest {
    @Test
    fun `a sum and a product err by their rounding`() {
        assertEquals(3 * ULP, error("f + f + f", 0.5), 2 * ULP)
        assertEquals(0.25 * ULP, error("f * f", 0.5), ULP / 1e6)
        assertEquals(0.0, error("f", 0.5))
    }

    @Test
    fun `a difference keeps the errors of what is subtracted`() {
        // sqrt(f) is off by 4.5 ulp of 0.7, whatever is left of it.
        assertEquals(4.5 * ULP * 0.7, error("sqrt(f) - 0.7071", 0.5), ULP)
    }

    @Test
    fun `a step errs by all of it where it could go either way`() {
        assertEquals(1.0, error("step(0.5, sin(f))", Math.asin(0.5)))
        assertEquals(0.0, error("step(0.5, sin(f))", 1.0))
        assertEquals(1.0, error("floor(sin(f) * 2.0)", Math.asin(0.5)))
    }

    @Test
    fun `a branch that could go either way is told`() {
        assertFalse(errors("0.0; if (sin(f) > 0.5) color.x = 1.0", Math.asin(0.5)).second.isDecided)
        assertTrue(errors("0.0; if (sin(f) > 0.5) color.x = 1.0", 1.0).second.isDecided)
    }

    @Test
    fun `what is no number has no bound`() {
        assertEquals(Double.POSITIVE_INFINITY, error("1.0 / (f - 0.5)", 0.5))
        assertEquals(Double.POSITIVE_INFINITY, error("pow(-f, 2.0)", 0.5))
        assertEquals(Double.POSITIVE_INFINITY, error("f * 1e38 * 1e38", 0.5))
    }

    private fun error(expression: String, f: Double): Double {
        val (tape, errors) = errors(expression, f)
        return errors.of(tape.references("color")[0])
    }

    private fun errors(expression: String, f: Double): Pair<Tape, RunningError> {
        val machine = Machine(fragment("color.x = $expression;", "uniform float f;"))
        machine["f"] = doubleArrayOf(f)
        val tape = Tape(machine.shader)
        machine.run(tape)
        return tape to RunningError(tape)
    }

    private companion object {
        const val ULP = 1.0 / (1 shl 23)
    }
}

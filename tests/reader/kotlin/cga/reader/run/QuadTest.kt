package cga.reader.run

import cga.reader.fragment
import cga.reader.tape.Tape
import cga.reader.tape.slice
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class QuadTest {
    @Test
    fun `derivatives are the differences of neighbours`() {
        val quad = quad("float q = x * x + 3.0 * y; color = vec4(dFdx(q), dFdy(q), fwidth(q), dFdx(q) * 2.0);")
        val tapes = List(4) { Tape(quad.machines[it].shader) }
        quad.run(tapes)
        // x is 1 and 3, so x² differs by 8; y is 5 and 6.
        for (machine in quad.machines) assertEquals(listOf(8.0, 3.0, 11.0, 16.0), machine["color"].asList())
        assertEquals(setOf("x", "y"), tapes[0].slices("color"))
    }

    @Test
    fun `a texture's level comes of the differences`() {
        val quad = quad("color = texture(t, vec2(x, y));", "uniform sampler2D t;")
        val gradients = HashSet<String>()
        val sampler = object : Sampler {
            override fun sample(look: TextureLook, result: DoubleArray) {
                gradients += "${look.gradientX.asList()} ${look.gradientY.asList()}"
            }

            override fun size(level: Int) = intArrayOf(1, 1)
        }
        for (machine in quad.machines) machine[machine.shader.uniforms.single()] = sampler
        assertEquals(List(4) { Outcome.DONE }, quad.run())
        assertEquals(setOf("[2.0, 0.0] [0.0, 1.0]"), gradients)
    }

    @Test
    fun `who has ended counts as equal, and who is ahead waits`() {
        val quad = quad("if (x > 2.0 && y > 5.5) discard; float s = 0.0; if (y > 5.5) s += dFdx(x); s += dFdy(y); color = vec4(s);")
        val outcomes = quad.run()
        assertEquals(listOf(Outcome.DONE, Outcome.DONE, Outcome.DONE, Outcome.DISCARDED), outcomes)
        assertEquals(listOf(1.0, 0.0, 1.0), quad.machines.take(3).map { it["color"][0] })
    }

    @Test
    fun `an endless loop ends here too`() {
        val quad = quad("float s = x; while (s > 0.0) s += abs(dFdx(x)); color = vec4(s);")
        assertEquals(List(4) { Outcome.TOO_LONG }, quad.run(steps = 1000))
    }

    private fun quad(body: String, declarations: String = "") =
        Quad(fragment(body, "in float x; in float y; $declarations")).apply {
            for ((i, machine) in machines.withIndex()) {
                machine["x"] = doubleArrayOf(1.0 + 2 * (i % 2))
                machine["y"] = doubleArrayOf(5.0 + i / 2)
            }
        }

    private fun Tape.slices(output: String) = slice(*references(output)).slots.map { it.name }.toSet()
}

package cga.reader.run

import cga.reader.color
import cga.reader.fragment
import cga.reader.shader
import cga.reader.shader.Stage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

class MachineTest {
    @Test
    fun `integers have 32 bits`() {
        val given = mapOf("i" to doubleArrayOf(2147483647.0), "u" to doubleArrayOf(4294967295.0))
        assertEquals(listOf(1.0, 1.0, 1.0, 1.0), color(WRAPPED, "uniform int i; uniform uint u;", given))
    }

    @Test
    fun `an index beyond an array is the nearest one within`() {
        val far = color("color = vec4(a[i], a[-i], 0.0, 0.0);", "uniform float a[3]; uniform int i;", places(7.0))
        assertEquals(listOf(3.0, 1.0), far.take(2))
    }

    @Test
    fun `the larger of a number and NaN is the number`() {
        assertEquals(
            listOf(2.0, 2.0, 0.0, 2.0),
            color("float x = 0.0 / f; color = vec4(max(x, 2.0), min(2.0, x), clamp(x, 0.0, 1.0), max(2.0, x));", "uniform float f;"),
        )
    }

    @Test
    fun `an endless loop ends with its name`() {
        val machine = Machine(fragment("float x = 1.0; while (x > 0.0) x += 1.0; color = vec4(x);"))
        assertEquals(Outcome.TOO_LONG, machine.run())
        assertEquals(Outcome.TOO_LONG, machine.run(steps = 10))
    }

    @Test
    fun `discard is an outcome`() {
        val machine = Machine(fragment("if (f < 0.5) discard; color = vec4(1.0);", "uniform float f;"))
        assertEquals(Outcome.DISCARDED, machine.run())
        machine["f"] = doubleArrayOf(1.0)
        assertEquals(Outcome.DONE, machine.run())
    }

    @Test
    fun `every run begins anew`() {
        val machine = Machine(fragment("count += 1.0; float x; x += count; color = vec4(x);", "float count = 2.0;"))
        repeat(3) {
            machine.run()
            assertEquals(3.0, machine["color"][0])
        }
    }

    @Test
    fun `a uniform has the value that the shader gives it, until it is set`() {
        val machine = Machine(fragment("color = vec4(k, 1.0);", "uniform vec3 k = vec3(1.0, 0.5, 0.25);"))
        machine.run()
        assertEquals(listOf(1.0, 0.5, 0.25, 1.0), machine["color"].asList())
        machine["k"] = doubleArrayOf(2.0, 3.0, 4.0)
        machine.run()
        assertEquals(listOf(2.0, 3.0, 4.0, 1.0), machine["color"].asList())
    }

    @Test
    fun `a name or a size that is wrong is told`() {
        val machine = Machine(fragment("color = vec4(k, 1.0);", "uniform vec3 k;"))
        assertEquals("the shader has no uniform, input or output kk", message { machine["kk"] = doubleArrayOf(1.0) })
        assertEquals("k takes 3 numbers, not 2", message { machine["k"] = doubleArrayOf(1.0, 2.0) })
    }

    @Test
    fun `a fragment takes what a vertex puts out`() {
        val vertex = Machine(shader("#version 330 core\nin vec3 a;\nout vec3 b[2];\nvoid main() { b[0] = a; b[1] = -a; }", Stage.VERTEX))
        vertex["a"] = doubleArrayOf(1.0, 2.0, 3.0)
        vertex.run()
        val fragment = Machine(fragment("color = vec4(b[0] * b[1], missing);", "in vec3 b[2]; in float missing;"))
        assertEquals(listOf("missing"), fragment.takeVaryings(vertex).map { it.name })
        fragment.run()
        assertEquals(listOf(-1.0, -4.0, -9.0, 0.0), fragment["color"].asList())
    }

    @Test
    fun `a vertex knows its number`() {
        val text = "#version 330 core\nout float x;\n" +
            "void main() { x = float(gl_VertexID + gl_InstanceID); gl_Position = vec4(x); gl_PointSize = 2.0; }"
        val machine = Machine(shader(text, Stage.VERTEX))
        machine["gl_VertexID"] = doubleArrayOf(5.0)
        machine["gl_InstanceID"] = doubleArrayOf(2.0)
        machine.run()
        assertEquals(7.0, machine["x"].single())
        assertEquals(List(4) { 7.0 }, machine["gl_Position"].asList())
        assertEquals(2.0, machine["gl_PointSize"].single())
    }

    private fun places(i: Double) =
        mapOf("a[0]" to doubleArrayOf(1.0), "a[1]" to doubleArrayOf(2.0), "a[2]" to doubleArrayOf(3.0), "i" to doubleArrayOf(i))

    private fun message(action: () -> Unit) = assertThrows<IllegalArgumentException> { action() }.message

    private companion object {
        const val WRAPPED =
            "color = vec4(i + 1 == -i - 1, u + 1u == 0u, i * 2 == -2, (u << 1u) == 4294967294u && (u >> 31u) == 1u && int(u) >> 4 == -1);"
    }
}

package cga.reader.tape

import cga.reader.fragment
import cga.reader.run.Machine
import cga.reader.run.Outcome
import cga.reader.run.Sampler
import cga.reader.shader.Kind
import cga.reader.shader.Operation
import cga.reader.shader.Shader
import cga.reader.shader.Source
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class TapeTest {
    @Test
    fun `every operation is there with its operands, its value and its line`() {
        val (_, tape) = run("color = vec4(f * 2.0 + g);")
        assertEquals(listOf(Operation.MUL, Operation.ADD), (0 until tape.size).map(tape::operation))
        assertEquals(listOf(10, 10), (0 until tape.size).map(tape::line))
        assertEquals(listOf("f_mul", "f_add"), (0 until tape.size).map(tape::origin))
        assertEquals(listOf("f", "2.0"), List(2) { named(tape, tape.operand(0, it)) })
        assertEquals(listOf("#0", "g"), List(2) { named(tape, tape.operand(1, it)) })
        assertEquals(listOf(2.0, 5.0), (0 until tape.size).map(tape::value))
        assertEquals(List(4) { 1 }, tape.references("color").asList())
    }

    @Test
    fun `numbers are followed through variables, parameters, arrays and loops`() {
        val (_, tape) = run(
            "float a[3]; for (int i = 0; i < 3; i++) a[i] = k[i]; vec3 v = vec3(a[2], f, g); swap(v); color = v.zyxx;",
            SWAP,
        )
        assertEquals(listOf("k[2]", "f", "g", "g"), tape.references("color").map { named(tape, it) })
    }

    @Test
    fun `a vector is one result, with the variable's name`() {
        val (_, tape) = run("vec3 n = normalize(vec3(f, g, 1.0)); color = vec4(n, 1.0);")
        val n = tape.results.single { it.name == "n" }
        assertEquals(10, n.line)
        assertEquals(listOf(Operation.MUL, Operation.MUL, Operation.MUL), n.references.map(tape::operation))
        assertEquals("normalize", tape.origin(n.references[0]))
        assertEquals(1.0, n.references.sumOf { tape.value(it) * tape.value(it) }, 1e-15)
        assertTrue(tape.results.any { it.name == "color" } && tape.results.any { it.name == null && it.origin == "normalize" })
    }

    @Test
    fun `what a branch that is not taken would assign is not there`() {
        val (_, tape) = run(
            "vec3 v = vec3(f);\nif (f > g)\nv = vec3(g);\nfor (int i = 0; i < 3; i++)\nif (i != 1) v = vec3(k[i], g, g);\ncolor = v.xyzx;",
        )
        assertEquals(listOf(10 to 0, 14 to 0, 14 to 2), tape.results.filter { it.name == "v" }.map { it.line to it.round })
        assertEquals(listOf("k[2]", "g", "g", "k[2]"), tape.references("color").map { named(tape, it) })
    }

    @Test
    fun `parameters are results by their own names`() {
        val (_, tape) = run("color = vec4(half_of(f));", "float half_of(float whole) {\nreturn whole * 0.5; }")
        assertEquals("f", named(tape, tape.results.single { it.name == "whole" }.references.single()))
    }

    @Test
    fun `a slice tells where a number comes from`() {
        val (_, tape) = run(
            "float a = f * g;\nfloat b = k[1] + 1.0;\ncolor = vec4(a, b, texture(t, vec2(g)).r, 1.0);",
            "uniform sampler2D t;",
        )
        val of = tape.references("color").map { tape.slice(it) }
        assertEquals(
            listOf(setOf("f", "g"), setOf("k[1]"), setOf("t", "g"), setOf()),
            of.map { slice ->
                slice.slots.map { it.name }.toSet()
            },
        )
        assertEquals(listOf(setOf(10), setOf(11), setOf(12), setOf()), of.map { it.lines })
        assertEquals(setOf(Source.Constant(1.0)), of[3].sources)
        assertEquals(listOf(Operation.MUL), of[0].entries().map(tape::operation))
        assertEquals(tape.entriesOfLine(10), of[0].entries())
    }

    @Test
    fun `a branch guards what it decides`() {
        val (_, tape) = run("float x = 0.0;\nif (f < g) {\nx = f * 3.0;\n}\ncolor = vec4(x + 1.0);")
        val product = (0 until tape.size).single { tape.operation(it) == Operation.MUL }
        val guard = tape.guard(product)
        assertEquals(Operation.BRANCH, tape.operation(guard))
        assertEquals(Operation.LESS, tape.operation(tape.operand(guard, 0)))
        assertEquals(-1, tape.guard(tape.references("color")[0]))
        val color = tape.references("color")
        assertEquals(setOf("f"), tape.slice(*color).slots.map { it.name }.toSet())
        assertEquals(setOf("f", "g"), tape.slice(*color, isGuarded = true).slots.map { it.name }.toSet())
    }

    @Test
    fun `rounds of a loop are the same place`() {
        val (_, tape) = run("float x = 0.0;\nfor (int i = 0; i < 3; i++)\nx += k[i];\ncolor = vec4(x);")
        val sums = tape.entriesOfLine(12).filter { tape.operation(it) == Operation.ADD }
        assertEquals(3, sums.size)
        assertEquals(1, sums.map(tape::place).distinct().size)
        assertEquals(listOf(0, 1, 2), sums.map(tape::round))
        assertEquals(listOf("k[0]", "k[1]", "k[2]"), sums.map { named(tape, tape.operand(it, 1)) })
        assertEquals(sums.take(2), sums.drop(1).map { tape.operand(it, 0) })
    }

    @Test
    fun `a round that is left early counts`() {
        val (_, tape) = run("for (int i = 0; i < 3; i++) {\nif (i == 1) continue;\nif (f < g) color += k[i] * g;\n}")
        val products = (0 until tape.size).filter { tape.operation(it) == Operation.MUL }
        assertEquals(listOf(0 to "k[0]", 2 to "k[2]"), products.map { tape.round(it) to named(tape, tape.operand(it, 0)) })
    }

    @Test
    fun `a variable that nothing was assigned to is known by its name`() {
        val (_, tape) = run("float forgotten; color = vec4(forgotten);")
        assertEquals(Source.Unset("forgotten"), tape.source(tape.references("color")[0]))
    }

    @Test
    fun `a tape can be used again`() {
        val (machine, tape) = run("for (float x = 0.0; x < f; x += 1.0) color += vec4(x);")
        val size = tape.size
        machine["f"] = doubleArrayOf(9.0)
        machine.run(tape)
        assertTrue(tape.size > 2 * size)
        machine["f"] = doubleArrayOf(1.0)
        machine.run(tape)
        assertEquals(size, tape.size)
    }

    @Test
    fun `what runs without a tape gives the same`() {
        val (machine, _) = run("color = vec4(pow(f, g), sin(g), mod(g, 2.0), 1.0);")
        val with = machine["color"].asList()
        machine.run()
        assertEquals(with, machine["color"].asList())
    }

    private fun run(body: String, declarations: String = ""): Pair<Machine, Tape> {
        val shader = fragment(body, "uniform float f; uniform float g; uniform float k[3]; $declarations")
        val machine = Machine(shader)
        setUp(machine, shader)
        val tape = Tape(shader)
        assertEquals(Outcome.DONE, machine.run(tape))
        return machine to tape
    }

    private fun setUp(machine: Machine, shader: Shader) {
        for (slot in shader.uniforms) {
            if (slot.kind ==
                Kind.SAMPLER
            ) {
                machine[slot] = Sampler.constant(1.0, 2.0, 3.0, 4.0)
            } else {
                machine[slot] =
                    doubleArrayOf(if (slot.name == "g") 3.0 else 1.0)
            }
        }
    }

    private fun named(tape: Tape, reference: Int): String =
        if (reference >= 0) {
            "#$reference"
        } else {
            when (val source = tape.source(reference)) {
                is Source.Constant -> "${source.value}"
                is Source.Uniform -> source.slot.name
                is Source.Input -> source.slot.name
                is Source.Unset -> "unset ${source.variable}"
            }
        }

    private companion object {
        const val SWAP = "void swap(inout vec3 v) { v = v.zyx; v.xz = v.zx; v = v.zyx; }"
    }
}

package cga.grading.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class DialectTest {
    private val plain = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n"

    @Test
    fun `what is as it should be is only tried with extensions`() {
        val only = Dialect.of(plain).single()
        assertTrue(only.startsWith("#version 330 core\n#extension "), only)
        assertTrue(only.endsWith(plain.substringAfter('\n')), only)
    }

    @Test
    fun `a byte order mark is left out`() = assertEquals(plain, Dialect.of("\uFEFF$plain").first())

    @Test
    fun `the version comes first, and lines keep their order`() {
        assertEquals("#version 330 core\n// mine\nvoid main() {}", Dialect.of("// mine\n  #version 330 core\nvoid main() {}").first())
        assertEquals("#version 330 core\nvoid main() {}", Dialect.of("void main() {}").first())
    }

    @Test
    fun `the version is one that there is`() {
        for (head in listOf("#version 330 compatibility", "#version 330core", "#version 330 Core;", " # version 330 core // mine")) {
            val said = Dialect.of("$head\nvoid main() {}").first().lines().first()
            assertTrue(said == "#version 330" || said == "#version 330 core", "$head: $said")
        }
        assertEquals("#version 300 es", Dialect.of("\n#version 300 es").first().lines().first())
    }

    private fun said(body: String): String = Dialect.of("#version 330 core\n$body").first().substringAfter('\n')

    @Test
    fun `whole numbers with the suffix of floats are floats`() {
        assertEquals("#define ONE 1.0\n", said("#define ONE 1f\n"))
        assertEquals("a = 1.0 + 0.0*b1f - 2.f - .5f - 1e2f - 0x1f; // 1f", said("a = 1f + 0F*b1f - 2.f - .5f - 1e2f - 0x1f; // 1f"))
    }

    @Test
    fun `casts are constructors`() {
        assertEquals("x = float( -f(a)[1].y) * 2;", said("x = (float) -f(a)[1].y * 2;"))
        assertEquals("return int( vec3((a + b)).x);", said("return (int) vec3((a + b)).x;"))
        assertEquals("x = float(int(y));", said("x = (float)(int)y;"))
        // What has no operand behind it is none.
        for (other in listOf(
            "float f(float);",
            "x = (a) + 1;",
            "x = (float)",
            "x = (float)(",
        )) {
            assertTrue(said(other).startsWith("#extension"))
        }
    }

    @Test
    fun `directives stand where they may and have no words to spare`() {
        assertEquals("#ifdef A\n#else\n#endif// B\nint x;", said("#ifdef A\n#else A\n#endif A // B\nint x;"))
        assertTrue(
            said("int x;\n#extension GL_ARB_gpu_shader5 : require\nint y;").startsWith("#extension GL_ARB_gpu_shader5 : enable\nint x;\n"),
        )
    }

    @Test
    fun `reserved names are others, unless they are asked for from outside`() {
        assertEquals("void main() { float input_own = input_own(1); }", said("void main() { float input = input(1); }"))
        assertEquals("float f(in float filter_own) { return filter_own; }", said("float f(in float filter) { return filter; }"))
        val asked = "uniform vec3 filter; struct L { bool active; }; in vec3 input; void main() { filter; L.active; input; }"
        assertTrue(said(asked).startsWith("#extension"))
        assertTrue(said(asked).endsWith(asked))
    }
}

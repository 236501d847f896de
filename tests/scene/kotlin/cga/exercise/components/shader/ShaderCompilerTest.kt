package cga.exercise.components.shader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** What drivers write of a mistake, and what we make of it. The logs are in the drivers' own forms. */
class ShaderCompilerTest {
    private val source = "#version 330 core\n\nvoid main() {\n    colour = vec4(1.0);\n}\n"

    @Test
    fun `Mesa's log`() = assertExplained(
        "0:4(5): error: `colour' undeclared\n",
        "a.frag:4: error: `colour' undeclared\n    colour = vec4(1.0);",
    )

    @Test
    fun `NVIDIA's log`() =
        assertExplained(
            "0(4) : error C1503: undefined variable \"colour\"\n",
            "a.frag:4: error C1503: undefined variable \"colour\"\n    colour = vec4(1.0);",
        )

    @Test
    fun `the log of AMD, Intel and Apple`() =
        assertExplained(
            "ERROR: 0:4: 'colour' : undeclared identifier \n",
            "a.frag:4: 'colour' : undeclared identifier\n    colour = vec4(1.0);",
        )

    @Test
    fun `their warnings`() = assertExplained("WARNING: 0:3: unused", "a.frag:3: unused\n    void main() {")

    @Test
    fun `every line of a log is explained, empty ones dropped`() =
        assertExplained(
            "0:3(1): warning: one\n\n0:5(1): error: two\n",
            "a.frag:3: warning: one\n    void main() {\na.frag:5: error: two\n    }",
        )

    @Test
    fun `what names no line is passed on`() = assertExplained("ERROR: 1 compilation errors.", "a.frag: ERROR: 1 compilation errors.")

    @Test
    fun `a line beyond the end has no text`() = assertExplained("0:99(1): error: syntax error", "a.frag:99: error: syntax error")

    @Test
    fun `Windows' line ends are no part of the text`() =
        assertEquals(
            "a.frag:2: error: x\n    b",
            ShaderCompiler.explain(ShaderSource.of("a.frag", "a\r\n  b\r\nc"), "0:2(1): error: x\r\n"),
        )

    private fun assertExplained(log: String, expected: String) = assertEquals(
        expected,
        ShaderCompiler.explain(ShaderSource.of("a.frag", source), log),
    )
}

package cga.grading.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PlainUniformsTest {
    private fun words(source: String) = source.replace(Regex("""\s+"""), " ").trim()

    @Test
    fun `a source without blocks is left as it is`() {
        val source = "uniform vec3 a; // uniform B { vec3 c; };\nstruct S { float x; };\nuniform S s;"
        val plain = PlainUniforms(source)
        assertSame(source, plain.source)
        assertNull(plain.name("S.x"))
    }

    @Test
    fun `the members of a block without an instance are uniforms by their own names`() {
        val plain =
            PlainUniforms(
                "layout(std140, row_major) uniform Lights {\n    vec4 at[3], tint;\n    layout(column_major) mat4 view;\n};\nvoid main() {}",
            )
        assertEquals("uniform vec4 at[3], tint; uniform mat4 view; void main() {}", words(plain.source))
        assertNull(plain.name("tint"))
    }

    @Test
    fun `a block with an instance is a struct`() {
        val plain = PlainUniforms("uniform Camera { mat4 view; vec3 eye; } cam ;")
        assertEquals("struct Camera_members { mat4 view; vec3 eye; }; uniform Camera_members cam;", words(plain.source))
        assertEquals("cam.view", plain.name("Camera.view"))
        assertEquals("cam.at[2].x", plain.name("Camera.at[2].x"))
        assertNull(plain.name("Other.view"))
    }

    @Test
    fun `lines for the preprocessor stay lines`() {
        val plain = PlainUniforms("uniform Lights {\n    vec4 a;\n#if 0\n    vec4 b;\n#endif\n};\n")
        val lines = plain.source.lines().map { it.trim() }
        assertTrue(lines.containsAll(listOf("uniform vec4 a;", "#if 0", "uniform vec4 b;", "#endif")), plain.source)
    }
}

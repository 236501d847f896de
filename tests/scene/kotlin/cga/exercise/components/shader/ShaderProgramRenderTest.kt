package cga.exercise.components.shader

import cga.framework.ColorFormat
import cga.framework.GLError
import cga.framework.InputError
import cga.framework.RenderTarget
import cga.testing.Offscreen
import cga.testing.projectRoot
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector4f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.extension.ExtendWith
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.opengl.GL33C.*
import java.nio.file.Path
import kotlin.io.path.deleteExisting
import kotlin.io.path.writeText

/** Programs that the driver compiles: what they draw, and what becomes of mistakes in them. */
@ExtendWith(Offscreen::class)
class ShaderProgramRenderTest {
    @TempDir
    private lateinit var folder: Path
    private val vertex get() = folder.resolve("a.vert")
    private val fragment get() = folder.resolve("a.frag")

    @Test
    fun `a compile error names file and line and shows the line`() {
        val source = ShaderSource.read("shaders/scene.frag").text
        val line = "vec3 toCamera = normalizeOrZero(toCameraView);"
        val number = source.lines().indexOfFirst { it.trim() == line } + 1
        fragment.writeText(source.replace(line, "vec3 toCamera = normaliseOrZero(toCameraView);"))
        val message = assertThrows<ShaderError> { ShaderProgram("shaders/scene.vert", "$fragment").use() }.message.orEmpty()
        assertTrue("$fragment:$number: " in message, message)
        assertTrue("\n    vec3 toCamera = normaliseOrZero(toCameraView);" in message, message)
        GLError.check("compiling a mistake")
    }

    @Test
    fun `a link error names both files and what is wrong`() {
        vertex.writeText(VERTEX.replace("void main", "out vec3 shade;\nvoid main").replace("}", "    shade = vec3(1.0);\n}"))
        fragment.writeText(fragment("shade", declarations = "in vec4 shade;"))
        val message = assertThrows<ShaderError> { ShaderProgram("$vertex", "$fragment").use() }.message.orEmpty()
        for (part in listOf("$vertex", "$fragment", "shade")) assertTrue(part in message, message)
    }

    @Test
    fun `reload takes the new shader, and keeps the old one where the new does not compile or is gone`() {
        val program = program(fragment("vec4(1, 0, 0, 1)"))
        assertEquals(RED, draw(program))
        fragment.writeText(fragment("vec4(0, 1, 0, 1)"))
        assertEquals(RED, draw(program), "before the reload")
        program.reload()
        assertEquals(GREEN, draw(program))

        fragment.writeText(fragment("vec4(0, 0, 1 1)"))
        assertThrows<ShaderError> { program.reload() }
        assertEquals(GREEN, draw(program), "after a compile error")
        fragment.writeText(fragment("shade()", declarations = "vec4 shade();"))
        assertThrows<ShaderError> { program.reload() }
        assertEquals(GREEN, draw(program), "after a link error")
        fragment.deleteExisting()
        assertThrows<InputError> { program.reload() }
        assertEquals(GREEN, draw(program), "after the file was deleted")

        fragment.writeText(fragment("vec4(1, 0, 0, 1)"))
        program.reload()
        assertEquals(RED, draw(program), "repaired")
    }

    @Test
    fun `reload finds the uniforms of the new shader`() {
        // In another order, so that their locations differ.
        val program = program(fragment("vec4(a, b, 0, 1)", "uniform float a;\nuniform float b;"))
        program.use()
        program.setUniform("a", 1f)
        program.setUniform("b", 0f)
        assertEquals(RED, draw(program))
        fragment.writeText(fragment("vec4(a, b, 0, 1)", "uniform float pad[5];\nuniform float b;\nuniform float a;"))
        program.reload()
        program.use()
        program.setUniform("a", 0f)
        program.setUniform("b", 1f)
        assertEquals(GREEN, draw(program))
    }

    @Test
    fun `used after cleanup it compiles again`() {
        val program = program(fragment("vec4(1, 0, 0, 1)"))
        assertEquals(RED, draw(program))
        program.cleanup()
        assertEquals(RED, draw(program))
    }

    @Test
    fun `an unknown uniform is reported once, with the nearest name`() {
        val warnings = mutableListOf<String>()
        vertex.writeText(VERTEX)
        fragment.writeText(
            fragment("vec4(material.shininess, other, 0, 1)", "struct M { float shininess; };\nuniform M material;\nuniform float other;"),
        )
        val program =
            object : ShaderProgram("$vertex", "$fragment") {
                override fun warn(message: String) {
                    warnings += message
                }
            }
        program.use()
        repeat(3) { program.setUniform("material.shinines", 1f) }
        assertEquals(1, warnings.size, "$warnings")
        for (part in listOf(
            "material.shinines ",
            "Did you mean material.shininess?",
            "$fragment",
        )) {
            assertTrue(part in warnings[0], warnings[0])
        }
        program.setUniform("material.shinines", Vector3f())
        program.setUniform("material.shininess", 1f)
        assertEquals(1, warnings.size, "$warnings")
        program.setUniform("othe", 1)
        assertEquals(2, warnings.size, "$warnings")
        GLError.check("setting unknown uniforms")
    }

    @Test
    fun `a uniform that is declared and not used is passed over`() {
        vertex.writeText(VERTEX)
        fragment.writeText(fragment("vec4(1, 0, 0, 1)", "uniform float idle;"))
        val program =
            object : ShaderProgram("$vertex", "$fragment") {
                override fun warn(message: String): Unit = throw AssertionError(message)
            }
        program.use()
        program.setUniform("idle", 1f)
    }

    @Test
    fun `members of structs that are declared and not used are passed over, misspelt ones and indices beyond the end are not`() {
        val warnings = mutableListOf<String>()
        vertex.writeText(VERTEX)
        fragment.writeText(
            fragment(
                "vec4(used[1].color, 1)",
                "struct L { vec3 position; vec3 color; };\nuniform L idle[2];\nuniform L used[2];",
            ),
        )
        val program =
            object : ShaderProgram("$vertex", "$fragment") {
                override fun warn(message: String) {
                    warnings += message
                }
            }
        program.use()
        for (name in listOf(
            "idle[0].position",
            "idle[1].color",
            "used[0].position",
            "used[1].position",
        )) {
            program.setUniform(name, Vector3f())
        }
        assertEquals(emptyList<String>(), warnings)
        for (name in listOf("idle[0].positon", "used[2].color", "other[0].color")) program.setUniform(name, Vector3f())
        assertEquals(listOf("idle[0].positon", "used[2].color", "other[0].color"), warnings.map { it.split(' ')[2] })
    }

    @Test
    fun `constants take the place of the numbers in the files, and the compiler's lines stay`() {
        val source = fragment("vec4(N == 3 ? 1 : 0, MORE == 1 ? 1 : 0, 0, 1)", "const int N = 12;\nconst int MORE = 1;")
        vertex.writeText(VERTEX)
        fragment.writeText(source)
        val constants = mapOf("N" to 3, "ELSEWHERE" to 4)
        assertEquals(listOf(1f, 1f, 0f, 1f), draw(ShaderProgram("$vertex", "$fragment", constants)))
        assertEquals(GREEN, draw(ShaderProgram("$vertex", "$fragment")))
        fragment.writeText(source.replace("vec4(N", "vec5(N"))
        val line = source.lines().indexOfFirst { "vec4(N" in it } + 1
        val error = assertThrows<ShaderError> { ShaderProgram("$vertex", "$fragment", constants).use() }
        assertTrue("$fragment:$line:" in error.message.orEmpty(), error.message)
    }

    @Test
    fun `every type of uniform arrives`() {
        fun assertSent(
            type: String,
            value: String,
            send: (ShaderProgram) -> Unit,
        ) {
            val program = program(fragment("u == $value ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1)", "uniform $type u;"))
            program.use()
            assertEquals(RED, draw(program), "$type is $value from the start")
            send(program)
            assertEquals(GREEN, draw(program), type)
        }
        val m3 = Matrix3f(1f, 2f, 3f, 4f, 5f, 6f, 7f, 8f, 9f)
        val m4 = Matrix4f(1f, 2f, 3f, 4f, 5f, 6f, 7f, 8f, 9f, 10f, 11f, 12f, 13f, 14f, 15f, 16f)
        assertSent("int", "-3") { it.setUniform("u", -3) }
        assertSent("bool", "true") { it.setUniform("u", true) }
        assertSent("float", "0.5") { it.setUniform("u", 0.5f) }
        assertSent("vec2", "vec2(1, 2)") { it.setUniform("u", Vector2f(1f, 2f)) }
        assertSent("vec3", "vec3(1, 2, 3)") { it.setUniform("u", Vector3f(1f, 2f, 3f)) }
        assertSent("vec4", "vec4(1, 2, 3, 4)") { it.setUniform("u", Vector4f(1f, 2f, 3f, 4f)) }
        assertSent("mat3", "mat3(1, 2, 3, 4, 5, 6, 7, 8, 9)") { it.setUniform("u", m3, false) }
        assertSent("mat3", "mat3(1, 4, 7, 2, 5, 8, 3, 6, 9)") { it.setUniform("u", m3, true) }
        assertSent("mat4", "mat4(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)") { it.setUniform("u", m4, false) }
        assertSent("mat4", "mat4(1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 4, 8, 12, 16)") { it.setUniform("u", m4, true) }
    }

    private fun program(fragmentSource: String): ShaderProgram {
        vertex.writeText(VERTEX)
        fragment.writeText(fragmentSource)
        return ShaderProgram("$vertex", "$fragment")
    }

    /** The colour that [program] gives one pixel. */
    private fun draw(program: ShaderProgram): List<Float> =
        RenderTarget(1, 1, 0, ColorFormat.RGBA32F).use { target ->
            val vertices = glGenVertexArrays()
            program.use()
            glBindVertexArray(vertices)
            glDrawArrays(GL_POINTS, 0, 1)
            glDeleteVertexArrays(vertices)
            GLError.check("drawing a point")
            target.readFloats().rgba.toList()
        }

    private companion object {
        val RED = listOf(1f, 0f, 0f, 1f)
        val GREEN = listOf(0f, 1f, 0f, 1f)
        const val VERTEX = "#version 330 core\nvoid main() {\n    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);\n}\n"

        fun fragment(
            color: String,
            declarations: String = "",
        ) = "#version 330 core\n$declarations\nout vec4 fragColor;\nvoid main() {\n    fragColor = $color;\n}\n"
    }
}

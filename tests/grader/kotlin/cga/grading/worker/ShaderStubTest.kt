package cga.grading.worker

import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL33C.*

/** Stubs are handed to the driver: what it says is active must be what the source declared. */
@ExtendWith(Offscreen::class)
class ShaderStubTest {
    private fun link(
        vertex: String,
        fragment: String,
    ): Int {
        val program = glCreateProgram()
        for ((stage, source) in listOf(GL_VERTEX_SHADER to vertex, GL_FRAGMENT_SHADER to fragment)) {
            val shader = glCreateShader(stage)
            glShaderSource(shader, source)
            glCompileShader(shader)
            assertEquals(GL_TRUE, glGetShaderi(shader, GL_COMPILE_STATUS), glGetShaderInfoLog(shader) + source)
            glAttachShader(program, shader)
        }
        glLinkProgram(program)
        assertEquals(GL_TRUE, glGetProgrami(program, GL_LINK_STATUS), glGetProgramInfoLog(program))
        return program
    }

    private fun uniforms(program: Int): Set<String> {
        val size = BufferUtils.createIntBuffer(1)
        val type = BufferUtils.createIntBuffer(1)
        return (0 until glGetProgrami(program, GL_ACTIVE_UNIFORMS)).map { glGetActiveUniform(program, it, size, type) }.toSet()
    }

    private val vertex =
        """
        #version 330 core
        layout(location = 0) in vec3 position;
        layout(location = 2) in vec3 normal;
        uniform mat4 model, view;   // uniform vec3 inComment;
        /* uniform vec3 alsoInComment; */
        uniform mat3 normalMatrix = mat3(1.0);
        out struct Data { vec3 normal; } ignored;
        out VertexData {
            vec3 toCamera;
            vec3 toLight[3];
        } vertexData;
        flat out int kind;
        void main() { gl_Position = modle * vec4(position, 1.0); }
        """.trimIndent().replace("out struct Data { vec3 normal; } ignored;\n", "")

    private val fragment =
        """
        #version 330 core
        #define LIGHTS 3
        const int SPOTS = 2;
        struct Falloff { vec3 k; };
        struct Light { vec3 color, position; Falloff falloff; float angles[2]; bool on; };
        in VertexData {
            vec3 toCamera;
            vec3 toLight[3];
        } vertexData;
        flat in int kind;
        uniform Light lights[LIGHTS];
        uniform Light spots[SPOTS];
        uniform sampler2D diffuse;
        uniform highp float shininess;
        uniform ivec2 size;
        layout(location = 0) out vec4 color;
        vec3 shade(in vec3 normal, in vec3 light) { return normal }
        void main() { color = vec4(1.0); }
        """.trimIndent()

    @Test
    fun `a stub has every uniform and attribute of its source`() {
        val program = link(ShaderStub(vertex, true).full, ShaderStub(fragment, false).full)
        val light = listOf("color", "position", "falloff.k", "angles[0]", "on")
        val expected =
            setOf("model", "view", "normalMatrix", "diffuse", "shininess", "size") +
                (0 until 3).flatMap { i -> light.map { "lights[$i].$it" } } + (0 until 2).flatMap { i -> light.map { "spots[$i].$it" } }
        assertEquals(expected, uniforms(program))
        assertEquals(listOf(0, 2), listOf("position", "normal").map { glGetAttribLocation(program, it) })
    }

    @Test
    fun `stubs that stand alone fit together whatever passes between the stages`() {
        val other = fragment.replace("vec3 toLight[3]", "vec4 toLight[4]")
        val program = link(ShaderStub(vertex, true).alone, ShaderStub(other, false).alone)
        assertNotEquals(-1, glGetUniformLocation(program, "lights[2].color"))
    }

    @Test
    fun `bare stubs fit together whatever the source is`() {
        link(ShaderStub("", true).bare, ShaderStub("}{;;struct in out uniform", false).bare)
    }
}

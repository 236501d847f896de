package cga.coach.numbers

import cga.coach.host.GlObjects
import cga.coach.host.GlWatch
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*

/** A shader with names of its own: two colours that add up, a place, and three factors that do not. */
@ExtendWith(Offscreen::class)
@Slow
class SourcesTest {
    private val numbers = Numbers()
    private val watch = GlWatch(numbers).apply {
        start()
        objects = GlObjects()
        isCloser = true
    }
    private val program = link()
    private val array = glGenVertexArrays()
    private val sources = Sources(numbers, ::draw)

    @AfterEach
    fun close() {
        glDeleteProgram(program)
        glDeleteVertexArrays(array)
        watch.isCloser = false
        numbers.close()
    }

    @Test
    fun `colours that the picture is a sum of are told from places and factors`() {
        draw()
        sources.begin()
        repeat(10) { sources.step() }
        assertTrue(sources.isDone)
        assertEquals(setOf("farbe", "lampe[1].hell"), sources.all.map { it.name }.toSet())
        val lamp = sources.all.first { it.name == "lampe[1].hell" }
        sources.solo(lamp)
        assertEquals(listOf(1f, 0f), listOf(lamp.scale, sources.all.first { it !== lamp }.scale))
        sources.solo(lamp)
        assertTrue(sources.all.all { it.scale == 1f })
    }

    @Test
    fun `a number that is held reaches the shader in the place of what is sent, whichever way it is sent`() {
        val both = listOf("farbe", "lampe[1].hell").map { name ->
            draw()
            val sent = numbers.all.first { it.name == name }
            sent.hold(0, 0f)
            sent.hold(1, 0f)
            sent.hold(2, 0f)
            val without = red()
            sent.release()
            red() to without
        }
        assertTrue(both.all { (with, without) -> with - without > 0.1f }) { "$both" }
        assertEquals(listOf(0.25f, 0.5f, 0.5f), numbers.all.first { it.name == "farbe" }.values.toList())
    }

    private fun red(): Float {
        draw()
        return FloatArray(4).also { glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, it) }[0]
    }

    private fun draw() {
        numbers.nextPicture()
        glUseProgram(program)
        glBindVertexArray(array)
        glUniform3f(glGetUniformLocation(program, "farbe"), 0.25f, 0.5f, 0.5f)
        glUniform3fv(glGetUniformLocation(program, "lampe[1].hell"), floatArrayOf(0.5f, 0.5f, 0.5f))
        glUniform3f(glGetUniformLocation(program, "lampe[1].ort"), 1f, 2f, 3f)
        glUniform3f(glGetUniformLocation(program, "k"), 1f, 0.5f, 0.1f)
        glDrawArrays(GL_TRIANGLES, 0, 3)
    }

    private fun link(): Int {
        val vertex =
            "#version 330 core\nvoid main() { " +
                "gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }"
        val shaders = listOf(GL_VERTEX_SHADER to vertex, GL_FRAGMENT_SHADER to FRAGMENT).map { (type, text) ->
            glCreateShader(type).also {
                glShaderSource(it, text)
                glCompileShader(it)
            }
        }
        return glCreateProgram().also { program ->
            shaders.forEach { glAttachShader(program, it) }
            glLinkProgram(program)
            assertEquals(GL_TRUE, glGetProgrami(program, GL_LINK_STATUS)) { glGetProgramInfoLog(program) }
            shaders.forEach { glDeleteShader(it) }
        }
    }

    private companion object {
        const val FRAGMENT =
            """#version 330 core
            struct Lampe { vec3 ort; vec3 hell; };
            uniform Lampe lampe[2];
            uniform vec3 farbe;
            uniform vec3 k;
            out vec4 c;
            void main() {
                float d = length(lampe[1].ort - vec3(gl_FragCoord.xy * 0.01, 0.0));
                c = vec4(farbe + lampe[1].hell / (k.x + k.y * d + k.z * d * d), 1.0);
            }
            """
    }
}

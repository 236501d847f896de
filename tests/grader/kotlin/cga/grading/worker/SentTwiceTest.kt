package cga.grading.worker

import cga.coach.calls.Call
import cga.grading.capture.EventKind
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

@ExtendWith(Offscreen::class)
class SentTwiceTest {
    private val tape = Tape()
    private val programs = Programs(tape)
    private val sentTwice = SentTwice(programs, tape, Callers(tape))
    private val program = program()
    private val location = glGetUniformLocation(program, "light")

    private fun program(): Int {
        val program = glCreateProgram()
        for ((stage, source) in listOf(
            GL_VERTEX_SHADER to "#version 330 core\nuniform vec3 light;\nvoid main() { gl_Position = vec4(light, 1.0); }",
            GL_FRAGMENT_SHADER to "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }",
        )) {
            val shader = glCreateShader(stage)
            glShaderSource(shader, source)
            glCompileShader(shader)
            glAttachShader(program, shader)
        }
        glLinkProgram(program)
        programs.linked(program)
        glUseProgram(program)
        return program
    }

    /** What the recorder does around a glUniform3f of the submission. */
    private fun send(red: Float) {
        glUniform3f(location, red, 0f, 0f)
        MemoryStack.stackPush().use { stack ->
            val arguments = stack.mallocPointer(1).put(0, stack.ints(location))
            sentTwice.note(Call("glUniform3f", 0, 0, 0, arguments.address()))
        }
    }

    private fun overwritten() = tape.capture().events.filter { it.kind == EventKind.UNIFORM_OVERWRITTEN }.map { it.text }

    @Test
    fun `another value before anything was drawn is noted, by the name that was asked for`() {
        programs.find(program)!!.asked[location] = "light"
        send(1f)
        send(1f)
        assertEquals(emptyList<String>(), overwritten())
        send(2f)
        assertEquals(listOf("light"), overwritten())
    }

    @Test
    fun `another value for another draw is not, nor one whose name nobody asked for`() {
        send(1f)
        send(2f)
        programs.find(program)!!.asked[location] = "light"
        send(1f)
        sentTwice.drawn()
        send(2f)
        assertEquals(emptyList<String>(), overwritten())
    }
}

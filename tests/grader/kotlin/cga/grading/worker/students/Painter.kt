package cga.grading.worker.students

import cga.framework.GameWindow
import org.lwjgl.opengl.GL33C.*

/**
 * What the students of these tests have in common: a small window and a program that paints triangles of two coordinates in a colour.
 *
 * They are compiled against this project's window and run on the grader's stand-in for it.
 */
internal abstract class Painter(samples: Int = 4) : GameWindow(WIDTH, HEIGHT, false, false, 3, 3, "painter", samples, 60) {
    protected var program = 0
    protected var vertices = 0
    protected var frame = -1

    override fun start() {
        program = link(VERTEX, FRAGMENT)
        glBindVertexArray(glGenVertexArrays())
        vertices = glGenBuffers()
        glBindBuffer(GL_ARRAY_BUFFER, vertices)
        glBufferData(GL_ARRAY_BUFFER, triangle(1f), GL_DYNAMIC_DRAW)
        glEnableVertexAttribArray(0)
        glVertexAttribPointer(0, 2, GL_FLOAT, false, 0, 0)
    }

    final override fun render(
        dt: Float,
        t: Float,
    ) {
        frame++
        glClearColor(0f, 0f, 0.2f, 1f)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        glUseProgram(program)
        paint()
    }

    protected open fun paint() {
        color(1f, 0.5f, 0f)
        glDrawArrays(GL_TRIANGLES, 0, 3)
    }

    protected fun color(
        red: Float,
        green: Float,
        blue: Float,
    ): Unit = glUniform3f(glGetUniformLocation(program, "color"), red, green, blue)

    protected fun triangle(size: Float) = floatArrayOf(-size, -size, size, -size, 0f, size)

    /** Says [what] on standard output, for the test to read. */
    protected fun say(what: Any): Unit = println(what)

    companion object {
        const val WIDTH = 64
        const val HEIGHT = 48
        const val VERTEX = "#version 330 core\nlayout(location = 0) in vec2 position;\nout vec2 place;\n" +
            "void main() {\n    place = position;\n    gl_Position = vec4(position, 0.0, 1.0);\n}\n"
        const val FRAGMENT = "#version 330 core\nin vec2 place;\nuniform vec3 color;\nout vec4 result;\n" +
            "void main() {\n    result = vec4(color * (0.5 + 0.5 * place.y), 1.0);\n}\n"

        /** Compiles without looking whether it went well. */
        fun compile(
            stage: Int,
            source: String,
        ): Int {
            val shader = glCreateShader(stage)
            glShaderSource(shader, source)
            glCompileShader(shader)
            return shader
        }

        fun link(
            vertex: String,
            fragment: String,
        ): Int {
            val program = glCreateProgram()
            glAttachShader(program, compile(GL_VERTEX_SHADER, vertex))
            glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment))
            glLinkProgram(program)
            return program
        }
    }
}

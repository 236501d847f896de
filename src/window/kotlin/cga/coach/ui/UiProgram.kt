package cga.coach.ui

import org.lwjgl.opengl.GL33C.*

/** The shaders that panels are drawn with. Made and used with the OpenGL context current. */
internal class UiProgram : AutoCloseable {
    private val program = glCreateProgram()
    private val font: Int
    private val windowSize: Int

    init {
        val shaders = listOf(compile(GL_VERTEX_SHADER, "ui.vert"), compile(GL_FRAGMENT_SHADER, "ui.frag"))
        shaders.forEach { glAttachShader(program, it) }
        glLinkProgram(program)
        check(glGetProgrami(program, GL_LINK_STATUS) == GL_TRUE) { "the panels' shaders: ${glGetProgramInfoLog(program)}" }
        shaders.forEach { glDeleteShader(it) }
        font = glGetUniformLocation(program, "font")
        windowSize = glGetUniformLocation(program, "windowSize")
    }

    private fun compile(
        type: Int,
        file: String,
    ): Int {
        val shader = glCreateShader(type)
        glShaderSource(shader, UiFiles.read(file).decodeToString())
        glCompileShader(shader)
        check(glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) { "$file: ${glGetShaderInfoLog(shader)}" }
        return shader
    }

    /** Makes it the program in use, for a window of [width]×[height] and the font at unit 0. */
    fun use(
        width: Float,
        height: Float,
    ) {
        glUseProgram(program)
        glUniform1i(font, 0)
        glUniform2f(windowSize, width, height)
    }

    override fun close() {
        glDeleteProgram(program)
    }
}

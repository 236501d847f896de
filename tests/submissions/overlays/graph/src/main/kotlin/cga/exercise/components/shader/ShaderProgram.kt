package cga.exercise.components.shader

import org.lwjgl.opengl.GL20.*
import java.io.File

class ShaderProgram(vertexShaderPath: String, fragmentShaderPath: String) {
    private val programID = glCreateProgram()
    val uniforms = Uniforms(programID)

    init {
        val vertexShader = compile(GL_VERTEX_SHADER, vertexShaderPath)
        val fragmentShader = compile(GL_FRAGMENT_SHADER, fragmentShaderPath)
        glAttachShader(programID, vertexShader)
        glAttachShader(programID, fragmentShader)
        glLinkProgram(programID)
        if (glGetProgrami(programID, GL_LINK_STATUS) == GL_FALSE) throw Exception(glGetProgramInfoLog(programID))
        glDeleteShader(vertexShader)
        glDeleteShader(fragmentShader)
    }

    private fun compile(type: Int, path: String): Int {
        val shader = glCreateShader(type)
        glShaderSource(shader, File(path).readText())
        glCompileShader(shader)
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) throw Exception(path + ": " + glGetShaderInfoLog(shader))
        return shader
    }

    fun use() {
        glUseProgram(programID)
    }

    fun cleanup() {
        glDeleteProgram(programID)
    }
}

package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL20.*
import java.io.File

class ShaderProgram(vertexShaderPath: String, fragmentShaderPath: String) {
    private val programID = glCreateProgram()
    private val matrixBuffer = BufferUtils.createFloatBuffer(16)

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

    fun setUniform(name: String, value: Int): Boolean {
        val location = glGetUniformLocation(programID, name)
        glUniform1i(location, value)
        return location != -1
    }

    fun setUniform(name: String, value: Float): Boolean {
        val location = glGetUniformLocation(programID, name)
        glUniform1f(location, value)
        return location != -1
    }

    fun setUniform(name: String, value: Vector2f): Boolean {
        val location = glGetUniformLocation(programID, name)
        glUniform2f(location, value.x, value.y)
        return location != -1
    }

    fun setUniform(name: String, value: Vector3f): Boolean {
        val location = glGetUniformLocation(programID, name)
        glUniform3f(location, value.x, value.y, value.z)
        return location != -1
    }

    fun setUniform(name: String, value: Matrix4f, transpose: Boolean): Boolean {
        val location = glGetUniformLocation(programID, name)
        glUniformMatrix4fv(location, transpose, value.get(matrixBuffer))
        return location != -1
    }
}

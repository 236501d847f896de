package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL20.*
import org.lwjgl.system.MemoryStack
import java.io.File

class ShaderProgram(vertexShaderPath: String, fragmentShaderPath: String) {
    private val programID = glCreateProgram()
    private val locations = HashMap<String, Int>()

    init {
        val shaders = listOf(GL_VERTEX_SHADER to vertexShaderPath, GL_FRAGMENT_SHADER to fragmentShaderPath).map { (type, path) ->
            val shader = glCreateShader(type)
            glShaderSource(shader, File(path).readText())
            glCompileShader(shader)
            check(glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) { "$path: ${glGetShaderInfoLog(shader)}" }
            glAttachShader(programID, shader)
            shader
        }
        glLinkProgram(programID)
        check(glGetProgrami(programID, GL_LINK_STATUS) == GL_TRUE) { glGetProgramInfoLog(programID) }
        shaders.forEach { glDeleteShader(it) }
    }

    fun use() = glUseProgram(programID)

    fun cleanup() = glDeleteProgram(programID)

    /** Asks for each uniform once, and complains once when there is none of the name. */
    private fun location(name: String): Int = locations.getOrPut(name) {
        val location = glGetUniformLocation(programID, name)
        if (location == -1) System.err.println("no uniform $name")
        location
    }

    fun setUniform(name: String, value: Boolean) = glUniform1i(location(name), if (value) 1 else 0)

    fun setUniform(name: String, value: Int) = glUniform1i(location(name), value)

    fun setUniform(name: String, value: Float) = glUniform1f(location(name), value)

    fun setUniform(name: String, value: Vector2f) = glUniform2f(location(name), value.x, value.y)

    fun setUniform(name: String, value: Vector3f) = glUniform3f(location(name), value.x, value.y, value.z)

    fun setUniform(name: String, value: Matrix4f, transpose: Boolean) {
        MemoryStack.stackPush().use { stack ->
            glUniformMatrix4fv(location(name), transpose, value.get(stack.mallocFloat(16)))
        }
    }
}

package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL20.*
import org.lwjgl.system.MemoryStack
import java.nio.file.Files
import java.nio.file.Paths

class ShaderProgram(vertexPath: String, fragmentPath: String) {
    private val id: Int = glCreateProgram()
    private val locations = mutableMapOf<String, Int>()

    init {
        val shaders = listOf(GL_VERTEX_SHADER to vertexPath, GL_FRAGMENT_SHADER to fragmentPath).map { (type, path) ->
            val source = String(Files.readAllBytes(Paths.get(path)))
            val shader = glCreateShader(type)
            glShaderSource(shader, source)
            glCompileShader(shader)
            check(glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) { "$path\n${glGetShaderInfoLog(shader)}" }
            glAttachShader(id, shader)
            shader
        }
        glLinkProgram(id)
        check(glGetProgrami(id, GL_LINK_STATUS) == GL_TRUE) { glGetProgramInfoLog(id) }
        shaders.forEach { glDeleteShader(it) }
    }

    private fun location(name: String): Int = locations.getOrPut(name) { glGetUniformLocation(id, name) }

    fun use() = glUseProgram(id)

    fun setInt(name: String, value: Int) = glUniform1i(location(name), value)

    fun setFloat(name: String, value: Float) = glUniform1f(location(name), value)

    fun setVec2(name: String, value: Vector2f) = glUniform2f(location(name), value.x, value.y)

    fun setVec3(name: String, value: Vector3f) = glUniform3f(location(name), value.x, value.y, value.z)

    fun setMat4(name: String, value: Matrix4f) {
        val stack = MemoryStack.stackPush()
        glUniformMatrix4fv(location(name), false, value.get(stack.mallocFloat(16)))
        stack.pop()
    }

    fun cleanup() = glDeleteProgram(id)
}

package cga.exercise.components.shader

import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL20.*
import java.io.File

/** The shaders NAME_vert.glsl and NAME_frag.glsl; a line `//#include FILE` is replaced by the file. */
class ShaderProgram(name: String) {
    val id = glCreateProgram()

    init {
        val shaders = listOf(compile(GL_VERTEX_SHADER, "${name}_vert.glsl"), compile(GL_FRAGMENT_SHADER, "${name}_frag.glsl"))
        shaders.forEach { glAttachShader(id, it) }
        glLinkProgram(id)
        check(glGetProgrami(id, GL_LINK_STATUS) == GL_TRUE) { "$name: " + glGetProgramInfoLog(id) }
        shaders.forEach { glDeleteShader(it) }
    }

    private fun source(file: String): String = File("assets/shaders/$file").readLines().joinToString("\n") { line ->
        if (line.startsWith("//#include ")) source(line.substringAfter(' ').trim()) else line
    }

    private fun compile(type: Int, file: String): Int {
        val shader = glCreateShader(type)
        glShaderSource(shader, source(file))
        glCompileShader(shader)
        check(glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) { "$file: " + glGetShaderInfoLog(shader) }
        return shader
    }

    fun use() = glUseProgram(id)

    fun cleanup() = glDeleteProgram(id)

    fun setUniform(name: String, value: Int) = glUniform1i(glGetUniformLocation(id, name), value)

    fun setUniform(name: String, value: Float) = glUniform1f(glGetUniformLocation(id, name), value)

    fun setUniform(name: String, value: Vector2f) = glUniform2f(glGetUniformLocation(id, name), value.x, value.y)

    fun setUniform(name: String, value: Vector3f) = glUniform3f(glGetUniformLocation(id, name), value.x, value.y, value.z)

    fun setUniform(name: String, value: Matrix4f) =
        glUniformMatrix4fv(glGetUniformLocation(id, name), false, value.get(FloatArray(16)))
}

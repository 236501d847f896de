package cga.exercise.components.shader

import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.opengl.GL20.*

/** Made from the text of the shaders itself: [ShaderWriter] writes it. */
class ShaderProgram(vertexSource: String, fragmentSource: String) {
    private val program = glCreateProgram()
    private val locations = HashMap<String, Int>()

    init {
        val parts = mapOf(GL_VERTEX_SHADER to vertexSource, GL_FRAGMENT_SHADER to fragmentSource).map { (type, source) ->
            val shader = glCreateShader(type)
            glShaderSource(shader, source)
            glCompileShader(shader)
            if (glGetShaderi(shader, GL_COMPILE_STATUS) != GL_TRUE) error(glGetShaderInfoLog(shader) + "\n" + source)
            glAttachShader(program, shader)
            shader
        }
        glLinkProgram(program)
        if (glGetProgrami(program, GL_LINK_STATUS) != GL_TRUE) error(glGetProgramInfoLog(program))
        parts.forEach(::glDeleteShader)
    }

    fun use() = glUseProgram(program)

    fun cleanup() = glDeleteProgram(program)

    private fun at(name: String) = locations.getOrPut(name) { glGetUniformLocation(program, name) }

    fun setUniform(name: String, value: Int) = glUniform1i(at(name), value)

    fun setUniform(name: String, value: Float) = glUniform1f(at(name), value)

    fun setUniform(name: String, value: Vector2f) = glUniform2f(at(name), value.x, value.y)

    fun setUniform(name: String, value: Vector3f) = glUniform3f(at(name), value.x, value.y, value.z)

    fun setUniform(name: String, value: Matrix3f) = glUniformMatrix3fv(at(name), false, value.get(FloatArray(9)))

    fun setUniform(name: String, value: Matrix4f, transpose: Boolean = false) =
        glUniformMatrix4fv(at(name), transpose, value.get(FloatArray(16)))
}

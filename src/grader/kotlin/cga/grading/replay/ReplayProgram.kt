package cga.grading.replay

import cga.grading.capture.CapturedProgram
import cga.grading.capture.GlNumbers
import cga.grading.capture.UniformValue
import org.lwjgl.opengl.GL33C.*

/** A captured program, compiled again. Throws [ReplayError] when it does not. */
internal class ReplayProgram(captured: CapturedProgram) {
    val name: Int = glCreateProgram()
    private val locations = HashMap<String, Int>()

    init {
        val shaders =
            try {
                listOf(GL_VERTEX_SHADER to captured.vertexSource, GL_FRAGMENT_SHADER to captured.fragmentSource)
                    .map { (stage, source) -> compile(stage, source) }
            } catch (e: ReplayError) {
                glDeleteProgram(name)
                throw e
            }
        shaders.forEach { glAttachShader(name, it) }
        // A matrix takes several locations and is named by the first.
        captured.attributes.forEach { (attribute, location) ->
            if (!attribute.startsWith("gl_")) glBindAttribLocation(name, location, attribute)
        }
        captured.outputs.forEach { (output, number) -> if (!output.startsWith("gl_")) glBindFragDataLocation(name, number, output) }
        glLinkProgram(name)
        shaders.forEach { glDeleteShader(it) }
        if (glGetProgrami(name, GL_LINK_STATUS) != GL_TRUE) {
            val log = glGetProgramInfoLog(name)
            glDeleteProgram(name)
            throw ReplayError("a captured program does not link: ${log.trim()}")
        }
    }

    /** Sets [uniform] to [numbers]; the program is in use. */
    fun set(
        uniform: UniformValue,
        numbers: FloatArray,
    ) {
        require(numbers.size == GlNumbers.components(uniform.type)) {
            "uniform ${uniform.name} takes ${uniform.numbers.size} numbers, not ${numbers.size}"
        }
        val location = locations.getOrPut(uniform.name) { glGetUniformLocation(name, uniform.name) }
        if (location < 0) return
        when (uniform.type) {
            GL_FLOAT_MAT2 -> glUniformMatrix2fv(location, false, numbers)
            GL_FLOAT_MAT3 -> glUniformMatrix3fv(location, false, numbers)
            GL_FLOAT_MAT4 -> glUniformMatrix4fv(location, false, numbers)
            GL_FLOAT_MAT2x3 -> glUniformMatrix2x3fv(location, false, numbers)
            GL_FLOAT_MAT3x2 -> glUniformMatrix3x2fv(location, false, numbers)
            GL_FLOAT_MAT2x4 -> glUniformMatrix2x4fv(location, false, numbers)
            GL_FLOAT_MAT4x2 -> glUniformMatrix4x2fv(location, false, numbers)
            GL_FLOAT_MAT3x4 -> glUniformMatrix3x4fv(location, false, numbers)
            GL_FLOAT_MAT4x3 -> glUniformMatrix4x3fv(location, false, numbers)
            else -> setVector(location, uniform.type, numbers)
        }
    }

    private fun setVector(
        location: Int,
        type: Int,
        numbers: FloatArray,
    ) {
        val whole = IntArray(numbers.size) { numbers[it].toLong().toInt() }
        when {
            GlNumbers.isWhole(type) ->
                when (numbers.size) {
                    1 -> glUniform1iv(location, whole)
                    2 -> glUniform2iv(location, whole)
                    3 -> glUniform3iv(location, whole)
                    else -> glUniform4iv(location, whole)
                }
            GlNumbers.isUnsigned(type) ->
                when (numbers.size) {
                    1 -> glUniform1uiv(location, whole)
                    2 -> glUniform2uiv(location, whole)
                    3 -> glUniform3uiv(location, whole)
                    else -> glUniform4uiv(location, whole)
                }
            else ->
                when (numbers.size) {
                    1 -> glUniform1fv(location, numbers)
                    2 -> glUniform2fv(location, numbers)
                    3 -> glUniform3fv(location, numbers)
                    else -> glUniform4fv(location, numbers)
                }
        }
    }

    private fun compile(
        stage: Int,
        source: String,
    ): Int {
        val shader = glCreateShader(stage)
        glShaderSource(shader, source)
        glCompileShader(shader)
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_TRUE) return shader
        val log = glGetShaderInfoLog(shader)
        glDeleteShader(shader)
        throw ReplayError("a captured shader does not compile: ${log.trim()}")
    }
}

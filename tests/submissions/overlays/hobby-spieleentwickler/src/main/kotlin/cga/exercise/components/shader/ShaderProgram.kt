package cga.exercise.components.shader

import org.lwjgl.opengl.GL20.*
import java.io.File

class ShaderProgram(vertexFile: String, fragmentFile: String) {
    private val handle = glCreateProgram()
    private val locations = HashMap<String, Int>()

    init {
        val stages = listOf(load(GL_VERTEX_SHADER, vertexFile), load(GL_FRAGMENT_SHADER, fragmentFile))
        stages.forEach { glAttachShader(handle, it) }
        glLinkProgram(handle)
        check(glGetProgrami(handle, GL_LINK_STATUS) == GL_TRUE) { "link: " + glGetProgramInfoLog(handle) }
        stages.forEach { glDeleteShader(it) }
    }

    private fun load(type: Int, file: String): Int {
        val stage = glCreateShader(type)
        glShaderSource(stage, File(file).readText())
        glCompileShader(stage)
        check(glGetShaderi(stage, GL_COMPILE_STATUS) == GL_TRUE) { file + ": " + glGetShaderInfoLog(stage) }
        return stage
    }

    /** asking the driver for each uniform in each frame is slow, so remember them */
    fun location(name: String): Int = locations.getOrPut(name) { glGetUniformLocation(handle, name) }

    fun use() = glUseProgram(handle)

    fun cleanup() = glDeleteProgram(handle)
}

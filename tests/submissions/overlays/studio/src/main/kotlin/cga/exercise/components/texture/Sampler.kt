package cga.exercise.components.texture

import org.lwjgl.opengl.GL33.*

/** How textures are read, apart from the textures. */
class Sampler(wrap: Int, minFilter: Int, magFilter: Int) {
    private val id = glGenSamplers()

    init {
        glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrap)
        glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrap)
        glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, minFilter)
        glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, magFilter)
    }

    fun bind(units: IntRange) {
        for (unit in units) glBindSampler(unit, id)
    }

    fun cleanup() = glDeleteSamplers(id)
}

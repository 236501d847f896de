package cga.exercise.components.texture

import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL30.*
import org.lwjgl.stb.STBImage.*
import java.nio.ByteBuffer

class Texture2D(imageData: ByteBuffer, width: Int, height: Int, genMipMaps: Boolean) {
    private val texID = glGenTextures()

    init {
        glBindTexture(GL_TEXTURE_2D, texID)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, imageData)
        if (genMipMaps) glGenerateMipmap(GL_TEXTURE_2D)
        setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR)
    }

    fun setTexParams(wrapS: Int, wrapT: Int, minFilter: Int, magFilter: Int) {
        glBindTexture(GL_TEXTURE_2D, texID)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapS)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapT)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minFilter)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magFilter)
        glBindTexture(GL_TEXTURE_2D, 0)
    }

    fun bind(textureUnit: Int) {
        glActiveTexture(GL_TEXTURE0 + textureUnit)
        glBindTexture(GL_TEXTURE_2D, texID)
    }

    fun unbind() {
        glBindTexture(GL_TEXTURE_2D, 0)
    }

    fun cleanup() {
        glDeleteTextures(texID)
    }

    companion object {
        operator fun invoke(path: String, genMipMaps: Boolean): Texture2D {
            val x = BufferUtils.createIntBuffer(1)
            val y = BufferUtils.createIntBuffer(1)
            val channels = BufferUtils.createIntBuffer(1)
            stbi_set_flip_vertically_on_load(true)
            val image = stbi_load(path, x, y, channels, 4) ?: throw Exception("$path: " + stbi_failure_reason())
            try {
                return Texture2D(image, x.get(), y.get(), genMipMaps)
            } finally {
                stbi_image_free(image)
            }
        }
    }
}

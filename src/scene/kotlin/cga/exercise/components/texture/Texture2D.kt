package cga.exercise.components.texture

import cga.framework.FrameTexture
import cga.framework.image.ImageData
import cga.framework.image.TextureImage
import org.joml.Vector3fc
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/**
 * A picture on the GPU, 8-bit linear RGBA, or a single colour in floats; uploaded when first bound, so a texture can be made without a
 * context.
 *
 * @param genMipMaps whether smaller levels are made for minification (see [TextureImage]).
 */
public class Texture2D private constructor(
    /** The texels, all mip levels. */
    public val image: TextureImage,
    private val genMipMaps: Boolean,
) {
    public constructor(imageData: ImageData, genMipMaps: Boolean) : this(TextureImage(imageData, genMipMaps), genMipMaps)

    /** A texture of one [color], linear RGB, which is neither rounded nor limited to 1. */
    public constructor(color: Vector3fc) : this(TextureImage.ofColor(color), false)

    private var texture = 0

    /** The sampling parameters in force, OpenGL's constants. */
    public var wrapS: Int = GL_REPEAT
        private set
    public var wrapT: Int = GL_REPEAT
        private set
    public var minFilter: Int = if (genMipMaps) GL_LINEAR_MIPMAP_LINEAR else GL_LINEAR
        private set
    public var magFilter: Int = GL_LINEAR
        private set

    /**
     * Sets how the texture repeats and how it is filtered, OpenGL's constants. A mipmapped [minFilter] without mipmaps, or a mipmapped
     * [magFilter], is an [IllegalArgumentException].
     */
    public fun setTexParams(
        wrapS: Int,
        wrapT: Int,
        minFilter: Int,
        magFilter: Int,
    ) {
        require(genMipMaps || minFilter == GL_NEAREST || minFilter == GL_LINEAR) {
            "minFilter 0x%X samples mipmaps and this texture has none: it would be black".format(minFilter)
        }
        require(magFilter == GL_NEAREST || magFilter == GL_LINEAR) {
            "magFilter 0x%X: magnification knows GL_NEAREST and GL_LINEAR only".format(magFilter)
        }
        this.wrapS = wrapS
        this.wrapT = wrapT
        this.minFilter = minFilter
        this.magFilter = magFilter
        if (texture != 0) {
            glBindTexture(GL_TEXTURE_2D, texture)
            applyTexParams()
        }
    }

    /** Makes this the texture of [textureUnit] (0, 1, …). */
    public fun bind(textureUnit: Int) {
        glActiveTexture(GL_TEXTURE0 + textureUnit)
        if (texture == 0) upload() else glBindTexture(GL_TEXTURE_2D, texture)
    }

    /** Leaves the active unit without a texture. */
    public fun unbind() {
        glBindTexture(GL_TEXTURE_2D, 0)
    }

    /** The texture as plain data. */
    public fun toFrameTexture(): FrameTexture = FrameTexture(image, wrapS, wrapT, minFilter, magFilter)

    /** Frees the GPU's copy; binding again uploads again. */
    public fun cleanup() {
        if (texture != 0) glDeleteTextures(texture)
        texture = 0
    }

    private fun upload() {
        texture = glGenTextures()
        glBindTexture(GL_TEXTURE_2D, texture)
        val color = image.color
        if (color == null) image.levels.forEachIndexed(::upload) else upload(color)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, image.levels.lastIndex)
        applyTexParams()
    }

    private fun upload(
        number: Int,
        level: TextureImage.Level,
    ) {
        val texels = MemoryUtil.memAlloc(level.rgba.size)
        texels.put(level.rgba).flip()
        glTexImage2D(GL_TEXTURE_2D, number, GL_RGBA8, level.width, level.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels)
        MemoryUtil.memFree(texels)
    }

    private fun upload(color: Vector3fc) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, 1, 1, 0, GL_RGB, GL_FLOAT, floatArrayOf(color.x(), color.y(), color.z()))
    }

    private fun applyTexParams() {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapS)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapT)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minFilter)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magFilter)
    }

    public companion object {
        /** The texture in the picture file at [path]. Throws [cga.framework.InputError] naming the file. */
        public operator fun invoke(
            path: String,
            genMipMaps: Boolean,
        ): Texture2D = Texture2D(TextureImage.read(path, genMipMaps), genMipMaps)
    }
}

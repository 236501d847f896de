package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedTexture
import cga.grading.capture.EventKind
import cga.grading.capture.GlNumbers
import org.lwjgl.opengl.EXTTextureFilterAnisotropic.GL_TEXTURE_MAX_ANISOTROPY_EXT
import org.lwjgl.opengl.GL33C.*

/** The contents of 2D textures, each read once after it was written to. */
internal class Textures(private val tape: Tape) {
    val writes: Writes = Writes()
    private val images = HashMap<Int, Image>()
    private val numbers = HashMap<List<Any>, Int?>()
    private val canBeAnisotropic = glGetString(GL_VERSION) != null && hasExtension("GL_EXT_texture_filter_anisotropic")

    private class Image(
        val count: Long,
        val width: Int,
        val height: Int,
        val levels: List<ByteArray>,
        val srgb: Boolean,
    )

    /** The number on the tape of the texture that is bound to the active unit; null when there is none that can be sampled or held. */
    fun number(
        name: Int,
        sampler: String,
    ): Int? {
        val image = image(name) ?: return null
        val wrapS = parameter(GL_TEXTURE_WRAP_S)
        val wrapT = parameter(GL_TEXTURE_WRAP_T)
        val minFilter = parameter(GL_TEXTURE_MIN_FILTER)
        val magFilter = parameter(GL_TEXTURE_MAG_FILTER)
        val key = listOf(name, image.count, wrapS, wrapT, minFilter, magFilter, anisotropy(minFilter))
        if (minFilter in GlNumbers.mipmapFilters && !isComplete(image)) {
            tape.event(EventKind.TEXTURE_INCOMPLETE, sampler)
            return null
        }
        unusual(wrapS, wrapT)?.let { tape.event(EventKind.NOT_CAPTURED, "$sampler: a texture with $it") }
        return numbers.getOrPut(key) {
            tape.add(
                CapturedTexture(
                    image.width, image.height, image.levels, wrapS, wrapT, minFilter, magFilter, anisotropy(minFilter), image.srgb,
                ),
            )
        }
    }

    private fun image(name: Int): Image? {
        val count = writes.count(name)
        images[name]?.takeIf { it.count == count }?.let { return it }
        return read(count)?.also { images[name] = it }
    }

    private fun read(count: Long): Image? {
        val width = level(0, GL_TEXTURE_WIDTH)
        val height = level(0, GL_TEXTURE_HEIGHT)
        if (width == 0 || height == 0) return null
        if (maxOf(width, height) > CaptureLimits.SIDE) return refuse("a texture of ${width}x$height")
        if (parameter(GL_TEXTURE_BASE_LEVEL) != 0) return refuse("a texture that begins at level ${parameter(GL_TEXTURE_BASE_LEVEL)}")
        val type = level(0, GL_TEXTURE_RED_TYPE)
        if (type != GL_UNSIGNED_NORMALIZED || level(0, GL_TEXTURE_RED_SIZE) > Byte.SIZE_BITS) {
            tape.event(EventKind.NOT_CAPTURED, "a texture of more than 8 bits a channel, held with 8")
        }
        val levels = ArrayList<ByteArray>()
        for (number in 0..minOf(parameter(GL_TEXTURE_MAX_LEVEL), lastLevel(width, height))) {
            if (level(number, GL_TEXTURE_WIDTH) != maxOf(1, width shr number)) break
            if (level(number, GL_TEXTURE_HEIGHT) != maxOf(1, height shr number)) break
            levels += tape.texels(texels(number)) ?: return null
        }
        val srgb = level(0, GL_TEXTURE_INTERNAL_FORMAT) in SRGB
        return Image(count, width, height, levels, srgb)
    }

    private fun texels(number: Int): ByteArray {
        val bytes = ByteArray(4 * level(number, GL_TEXTURE_WIDTH) * level(number, GL_TEXTURE_HEIGHT))
        Packing.plain {
            Native.bytes(bytes.size) {
                glGetTexImage(GL_TEXTURE_2D, number, GL_RGBA, GL_UNSIGNED_BYTE, it)
                it.get(bytes)
            }
        }
        return bytes
    }

    private fun isComplete(image: Image): Boolean =
        image.levels.size > minOf(parameter(GL_TEXTURE_MAX_LEVEL), lastLevel(image.width, image.height))

    /** The anisotropy in force. Software rendering can hang on one without mipmaps, where it means little: it is turned off there. */
    private fun anisotropy(minFilter: Int): Float {
        if (!canBeAnisotropic) return 1f
        val value = glGetTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT)
        if (value > 1f && minFilter !in GlNumbers.mipmapFilters) {
            glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 1f)
            return 1f
        }
        return value
    }

    private fun unusual(
        wrapS: Int,
        wrapT: Int,
    ): String? =
        when {
            GL_CLAMP_TO_BORDER in listOf(wrapS, wrapT) -> "a border"
            glGetTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS) != 0f -> "a level-of-detail bias"
            parameter(GL_TEXTURE_COMPARE_MODE) != GL_NONE -> "a comparison"
            SWIZZLE.any { (name, value) -> parameter(name) != value } -> "swizzled channels"
            else -> null
        }

    private fun refuse(what: String): Image? {
        tape.event(EventKind.NOT_CAPTURED, what)
        return null
    }

    private fun parameter(name: Int) = glGetTexParameteri(GL_TEXTURE_2D, name)

    private fun level(
        number: Int,
        name: Int,
    ) = glGetTexLevelParameteri(GL_TEXTURE_2D, number, name)

    private fun lastLevel(
        width: Int,
        height: Int,
    ) = Int.SIZE_BITS - 1 - maxOf(width, height).countLeadingZeroBits()

    private fun hasExtension(name: String) = (0 until glGetInteger(GL_NUM_EXTENSIONS)).any { glGetStringi(GL_EXTENSIONS, it) == name }

    private companion object {
        val SRGB = setOf(GL_SRGB, GL_SRGB8, GL_SRGB_ALPHA, GL_SRGB8_ALPHA8)
        val SWIZZLE =
            mapOf(
                GL_TEXTURE_SWIZZLE_R to GL_RED,
                GL_TEXTURE_SWIZZLE_G to GL_GREEN,
                GL_TEXTURE_SWIZZLE_B to GL_BLUE,
                GL_TEXTURE_SWIZZLE_A to GL_ALPHA,
            )
    }
}

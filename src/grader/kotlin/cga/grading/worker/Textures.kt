package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedTexture
import cga.grading.capture.EventKind
import cga.grading.capture.GlNumbers
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/** The contents of 2D textures and cube maps, each read once after it was written to. */
internal class Textures(private val tape: Tape) {
    val writes: Writes = Writes()
    private val images = HashMap<Int, Image>()
    private val numbers = HashMap<List<Any>, Int?>()
    private var target = TextureTarget.FLAT

    private class Image(
        val count: Long,
        val width: Int,
        val height: Int,
        val levels: List<ByteArray>,
        val srgb: Boolean,
        val depth: Int,
    )

    /**
     * The number on the tape of the texture [name] that is bound at [target] of the active unit; null when there is none that can be sampled or
     * held. A sampler object that is bound there decides how it is filtered.
     */
    fun number(
        name: Int,
        target: TextureTarget,
        sampler: String,
    ): Int? {
        this.target = target
        val image = image(name) ?: return null
        val wrapS = filtering(GL_TEXTURE_WRAP_S)
        val wrapT = filtering(GL_TEXTURE_WRAP_T)
        val wrapR = filtering(GL_TEXTURE_WRAP_R)
        val minFilter = filtering(GL_TEXTURE_MIN_FILTER)
        val magFilter = filtering(GL_TEXTURE_MAG_FILTER)
        val border = if (GL_CLAMP_TO_BORDER in listOf(wrapS, wrapT, wrapR)) border() else null
        val key = listOf(name, image.count, wrapS, wrapT, wrapR, minFilter, magFilter, border.orEmpty())
        if (minFilter in GlNumbers.mipmapFilters && !isComplete(image)) {
            tape.event(EventKind.TEXTURE_INCOMPLETE, sampler)
            return null
        }
        unusual()?.let { tape.event(EventKind.NOT_CAPTURED, "$sampler: a texture with $it") }
        return numbers.getOrPut(key) {
            tape.add(
                CapturedTexture(
                    image.width, image.height, image.levels, wrapS, wrapT, minFilter, magFilter, NO_ANISOTROPY, image.srgb,
                    target == TextureTarget.CUBE, wrapR, image.depth, border,
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
        if (!hasLevel(0, width, height)) return null
        if (maxOf(width, height) > CaptureLimits.SIDE) return refuse("a texture of ${width}x$height")
        if (parameter(GL_TEXTURE_BASE_LEVEL) != 0) return refuse("a texture that begins at level ${parameter(GL_TEXTURE_BASE_LEVEL)}")
        val isDepth = level(0, GL_TEXTURE_DEPTH_SIZE) > 0
        // Seen with llvmpipe: depths that were just drawn are read as those of before otherwise.
        if (isDepth) glFinish()
        val type = level(0, GL_TEXTURE_RED_TYPE)
        if (isDepth) {
            if (target == TextureTarget.CUBE) return refuse("a cube map of depths")
        } else if (type != GL_UNSIGNED_NORMALIZED || level(0, GL_TEXTURE_RED_SIZE) > Byte.SIZE_BITS) {
            tape.event(EventKind.NOT_CAPTURED, "a texture of more than 8 bits a channel, held with 8")
        }
        val levels = ArrayList<ByteArray>()
        for (number in 0..minOf(parameter(GL_TEXTURE_MAX_LEVEL), lastLevel(width, height))) {
            if (!hasLevel(number, maxOf(1, width shr number), maxOf(1, height shr number))) break
            levels += tape.texels(texels(number, isDepth)) ?: return null
        }
        val format = level(0, GL_TEXTURE_INTERNAL_FORMAT)
        return Image(count, width, height, levels, format in SRGB, if (isDepth) DEPTHS[format] ?: format else 0)
    }

    /** Whether all sides have a picture of this size. */
    private fun hasLevel(
        number: Int,
        width: Int,
        height: Int,
    ) = width > 0 && height > 0 &&
        target.sides.all { level(number, GL_TEXTURE_WIDTH, it) == width && level(number, GL_TEXTURE_HEIGHT, it) == height }

    private fun texels(
        number: Int,
        isDepth: Boolean,
    ): ByteArray {
        val side = 4 * level(number, GL_TEXTURE_WIDTH) * level(number, GL_TEXTURE_HEIGHT)
        val bytes = ByteArray(side * target.sides.size)
        Packing.plain {
            Native.bytes(side) {
                target.sides.forEachIndexed { i, at ->
                    if (isDepth) {
                        glGetTexImage(at, number, GL_DEPTH_COMPONENT, GL_FLOAT, it)
                    } else {
                        glGetTexImage(at, number, GL_RGBA, GL_UNSIGNED_BYTE, it)
                    }
                    it.get(0, bytes, i * side, side)
                }
            }
        }
        return bytes
    }

    private fun isComplete(image: Image): Boolean =
        image.levels.size > minOf(parameter(GL_TEXTURE_MAX_LEVEL), lastLevel(image.width, image.height))

    /** A parameter that a sampler object takes over. */
    private fun filtering(name: Int): Int {
        val sampler = glGetInteger(GL_SAMPLER_BINDING)
        return if (sampler == 0) parameter(name) else glGetSamplerParameteri(sampler, name)
    }

    private fun border(): List<Float> =
        MemoryStack.stackPush().use { stack ->
            val four = stack.mallocFloat(4)
            val sampler = glGetInteger(GL_SAMPLER_BINDING)
            if (sampler == 0) {
                glGetTexParameterfv(target.bound, GL_TEXTURE_BORDER_COLOR, four)
            } else {
                glGetSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, four)
            }
            List(4) { four[it] }
        }

    private fun unusual(): String? =
        when {
            glGetTexParameterf(target.bound, GL_TEXTURE_LOD_BIAS) != 0f -> "a level-of-detail bias"
            parameter(GL_TEXTURE_COMPARE_MODE) != GL_NONE -> "a comparison"
            SWIZZLE.any { (name, value) -> parameter(name) != value } -> "swizzled channels"
            else -> null
        }

    private fun refuse(what: String): Image? {
        tape.event(EventKind.NOT_CAPTURED, what)
        return null
    }

    private fun parameter(name: Int) = glGetTexParameteri(target.bound, name)

    private fun level(
        number: Int,
        name: Int,
        side: Int = target.sides[0],
    ) = glGetTexLevelParameteri(side, number, name)

    private fun lastLevel(
        width: Int,
        height: Int,
    ) = Int.SIZE_BITS - 1 - maxOf(width, height).countLeadingZeroBits()

    private companion object {
        /** See [Anisotropy]. */
        const val NO_ANISOTROPY = 1f

        /** The formats with a stencil hold depths like those without. */
        val DEPTHS = mapOf(
            GL_DEPTH24_STENCIL8 to GL_DEPTH_COMPONENT24,
            GL_DEPTH32F_STENCIL8 to GL_DEPTH_COMPONENT32F,
            GL_DEPTH_STENCIL to GL_DEPTH_COMPONENT24,
        )
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

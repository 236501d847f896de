package cga.framework

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil

/** How a [RenderTarget] stores colour: always linear, never sRGB. */
public enum class ColorFormat(internal val gl: Int) {
    /** 8 bits a channel, clamped to 0..1: what a screen shows. */
    RGBA8(GL_RGBA8),

    /** 16-bit floats, unclamped: half the memory of the next. */
    RGBA16F(GL_RGBA16F),

    /** 32-bit floats, unclamped: for measuring. */
    RGBA32F(GL_RGBA32F),
}

/**
 * A framebuffer of its own to render into and read back, with a 24-bit depth buffer.
 *
 * @param samples 0 for none; otherwise at least so many samples a pixel, averaged when the picture is read.
 * Throws [InputError] when the driver cannot make one of that size or with so many samples.
 */
public class RenderTarget(
    public val width: Int,
    public val height: Int,
    public val samples: Int = 0,
    private val format: ColorFormat = ColorFormat.RGBA8,
) : AutoCloseable {
    private val drawn: Attachments
    private val resolved: Attachments?

    init {
        checkSize(width, height)
        checkSamples(samples)
        drawn = Attachments(samples)
        resolved = if (samples > 0) Attachments(0) else null
        GLError.check("making a ${width}x$height render target")
        bind()
    }

    /** Directs drawing here, the whole picture as viewport. */
    public fun bind() {
        glBindFramebuffer(GL_FRAMEBUFFER, drawn.framebuffer)
        glViewport(0, 0, width, height)
    }

    /** The picture as 8-bit numbers; of a float target it is what a screen would show. */
    public fun read(): ImageData {
        val pixels = MemoryUtil.memAlloc(4 * width * height)
        try {
            bindForReading()
            glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels)
            val rgba = ByteArray(pixels.capacity())
            for (row in 0 until height) pixels.get(4 * width * (height - 1 - row), rgba, 4 * width * row, 4 * width)
            return ImageData(width, height, rgba)
        } finally {
            MemoryUtil.memFree(pixels)
            bind()
        }
    }

    /** The picture as floats. */
    public fun readFloats(): FloatImage {
        val pixels = MemoryUtil.memAllocFloat(4 * width * height)
        try {
            bindForReading()
            glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels)
            val rgba = FloatArray(pixels.capacity())
            for (row in 0 until height) pixels.get(4 * width * (height - 1 - row), rgba, 4 * width * row, 4 * width)
            return FloatImage(width, height, rgba)
        } finally {
            MemoryUtil.memFree(pixels)
            bind()
        }
    }

    override fun close() {
        drawn.delete()
        resolved?.delete()
    }

    private fun bindForReading() {
        if (resolved != null) {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn.framebuffer)
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.framebuffer)
            glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST)
        }
        glBindFramebuffer(GL_READ_FRAMEBUFFER, (resolved ?: drawn).framebuffer)
    }

    private inner class Attachments(samples: Int) {
        val framebuffer = glGenFramebuffers()
        private val color = glGenRenderbuffers()
        private val depth = glGenRenderbuffers()

        init {
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
            attach(color, GL_COLOR_ATTACHMENT0, format.gl, samples)
            attach(depth, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, samples)
            val status = glCheckFramebufferStatus(GL_FRAMEBUFFER)
            check(status == GL_FRAMEBUFFER_COMPLETE) { "the driver refuses a $format framebuffer (status 0x%X)".format(status) }
        }

        private fun attach(
            buffer: Int,
            point: Int,
            storage: Int,
            samples: Int,
        ) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffer)
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, storage, width, height)
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer)
        }

        fun delete() {
            glDeleteFramebuffers(framebuffer)
            glDeleteRenderbuffers(color)
            glDeleteRenderbuffers(depth)
        }
    }

    internal companion object {
        private fun checkSize(
            width: Int,
            height: Int,
        ) {
            val limit = glGetInteger(GL_MAX_RENDERBUFFER_SIZE)
            // A Java array ends at 2³¹ elements, and a picture has four a pixel.
            val pixels = Int.MAX_VALUE / 4
            if (width < 1 || height < 1 || width > limit || height > limit || width.toLong() * height > pixels) {
                throw InputError("size ${width}x$height cannot be rendered: give 1x1 to ${limit}x$limit, at most $pixels pixels in all.")
            }
        }

        /** Throws [InputError] when the current context's driver does not have so many samples a pixel. */
        fun checkSamples(samples: Int) {
            val limit = glGetInteger(GL_MAX_SAMPLES)
            if (samples !in 0..limit) throw InputError("$samples samples a pixel cannot be rendered: this driver has 0 to $limit.")
        }
    }
}

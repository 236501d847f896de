package cga.grading.worker

import org.lwjgl.opengl.GL33C.*

/**
 * A framebuffer object in the place of the window's own, which off screen has no samples.
 *
 * @param samples wished for; the driver's most are given where it has fewer, as GLFW does.
 */
internal class WindowFramebuffer(
    val width: Int,
    val height: Int,
    samples: Int,
) {
    val samples: Int = samples.coerceIn(0, glGetInteger(GL_MAX_SAMPLES))
    private val resolved: Int

    /** OpenGL's name of it, which stands for 0. */
    val name: Int

    init {
        resolved = if (this.samples > 0) create(0) else 0
        name = create(this.samples)
        glBindFramebuffer(GL_FRAMEBUFFER, name)
    }

    /** Brings it into the state in which every frame finds it: black, transparent, farthest. Changes no state. */
    fun clear() {
        val before = glGetInteger(GL_DRAW_FRAMEBUFFER_BINDING)
        val scissor = glIsEnabled(GL_SCISSOR_TEST)
        val depthMask = glGetBoolean(GL_DEPTH_WRITEMASK)
        val colorMask = BooleanArray(4)
        Native.bytes(4) { bytes ->
            glGetBooleanv(GL_COLOR_WRITEMASK, bytes)
            for (i in colorMask.indices) colorMask[i] = bytes[i] != 0.toByte()
        }
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name)
        glDisable(GL_SCISSOR_TEST)
        glDepthMask(true)
        glColorMask(true, true, true, true)
        glClearBufferfv(GL_COLOR, 0, floatArrayOf(0f, 0f, 0f, 0f))
        glClearBufferfi(GL_DEPTH_STENCIL, 0, 1f, 0)
        glColorMask(colorMask[0], colorMask[1], colorMask[2], colorMask[3])
        glDepthMask(depthMask)
        if (scissor) glEnable(GL_SCISSOR_TEST)
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, before)
    }

    /** Its picture, RGBA, top row first. Changes no state. */
    fun read(): ByteArray =
        readable {
            Packing.plain {
                val rgba = ByteArray(4 * width * height)
                Native.bytes(rgba.size) { pixels ->
                    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels)
                    for (row in 0 until height) pixels.get(4 * width * (height - 1 - row), rgba, 4 * width * row, 4 * width)
                }
                rgba
            }
        }

    /** Runs [block] with the picture, samples averaged, as the framebuffer that is read from. */
    fun <T> readable(block: () -> T): T {
        val read = glGetInteger(GL_READ_FRAMEBUFFER_BINDING)
        val draw = glGetInteger(GL_DRAW_FRAMEBUFFER_BINDING)
        val scissor = glIsEnabled(GL_SCISSOR_TEST)
        glBindFramebuffer(GL_READ_FRAMEBUFFER, name)
        val buffer = glGetInteger(GL_READ_BUFFER)
        glReadBuffer(GL_COLOR_ATTACHMENT0)
        if (samples > 0) {
            glDisable(GL_SCISSOR_TEST)
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved)
            glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST)
            if (scissor) glEnable(GL_SCISSOR_TEST)
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw)
            glReadBuffer(buffer)
            glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved)
        }
        try {
            return block()
        } finally {
            if (samples == 0) glReadBuffer(buffer)
            glBindFramebuffer(GL_READ_FRAMEBUFFER, read)
        }
    }

    /** Whether drawing goes here now. */
    fun isDrawnTo(): Boolean = glGetInteger(GL_DRAW_FRAMEBUFFER_BINDING) == name

    /** Whether reading reads here now. */
    fun isReadFrom(): Boolean = glGetInteger(GL_READ_FRAMEBUFFER_BINDING) == name

    private fun create(samples: Int): Int {
        val framebuffer = glGenFramebuffers()
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, samples)
        attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, samples)
        val status = glCheckFramebufferStatus(GL_FRAMEBUFFER)
        check(status == GL_FRAMEBUFFER_COMPLETE) { "no framebuffer of ${width}x$height with $samples samples (status $status)" }
        return framebuffer
    }

    private fun attach(
        point: Int,
        storage: Int,
        samples: Int,
    ) {
        val buffer = glGenRenderbuffers()
        glBindRenderbuffer(GL_RENDERBUFFER, buffer)
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, storage, width, height)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer)
        glBindRenderbuffer(GL_RENDERBUFFER, 0)
    }
}

package cga.coach.host

import cga.framework.RenderTarget
import org.lwjgl.opengl.GL33C.*

/** Keeps a copy of the window's last good picture, for the time when there is no new one. Needs the context. */
internal class LastPicture : AutoCloseable {
    private var copy: RenderTarget? = null

    /** Whether there is one. */
    val isThere: Boolean get() = copy != null

    /** Copies what [buffer] (`GL_BACK` or `GL_FRONT`) of the window shows, [width]×[height] pixels. */
    fun keep(
        buffer: Int,
        width: Int,
        height: Int,
    ) {
        val target = copy?.takeIf { it.width == width && it.height == height } ?: RenderTarget(width, height).also {
            copy?.close()
            copy = it
        }
        target.bind()
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0)
        glReadBuffer(buffer)
        blit(target, width, height)
        glReadBuffer(GL_BACK)
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
    }

    /** Puts it into the window of [width]×[height] pixels. */
    fun show(
        width: Int,
        height: Int,
    ) {
        val target = copy ?: return
        target.bind()
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0)
        blit(target, width, height)
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
    }

    private fun blit(
        target: RenderTarget,
        width: Int,
        height: Int,
    ) = glBlitFramebuffer(0, 0, target.width, target.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST)

    override fun close() {
        copy?.close()
        copy = null
    }
}

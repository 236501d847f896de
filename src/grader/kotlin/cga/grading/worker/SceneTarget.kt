package cga.grading.worker

import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/**
 * A framebuffer of the submission's own that it draws its scene into, to show that as a picture in its window afterwards. The scene is laid
 * bare: it is drawn into the window itself, and what would have shown it is left out.
 *
 * Such a framebuffer has one colour buffer of about the window's shape, no smaller than half of it, and a depth buffer. One for shadows has
 * no colour, and one for a mirror gets a scene that is drawn into the window as well: then nothing is laid bare any more.
 */
internal class SceneTarget(private val window: WindowFramebuffer) {
    private val shown = HashSet<Int>()
    private val programs = HashSet<Int>()
    private var target = 0

    /** Whether it is a mirror after all. */
    private var isMirror = false

    /** Whether this frame's scene has begun to be drawn in the window's place. */
    val hasScene: Boolean get() = target != 0

    /** Begins a frame. */
    fun begin() {
        target = 0
        programs.clear()
    }

    /** Whether what is drawn or cleared now belongs into the window instead of where it goes. */
    fun isScene(): Boolean {
        val name = glGetInteger(GL_DRAW_FRAMEBUFFER_BINDING)
        if (name == window.name || isMirror) return false
        return if (hasScene) name == target else isForScene()
    }

    /** Runs [block] with the window in the place of the framebuffer that [isScene]. */
    fun inWindow(block: () -> Unit) {
        val name = glGetInteger(GL_DRAW_FRAMEBUFFER_BINDING)
        val (width, height) = size() ?: return block()
        target = name
        texture()?.let(shown::add)
        programs += glGetInteger(GL_CURRENT_PROGRAM)
        MemoryStack.stackPush().use { stack ->
            val viewport = stack.mallocInt(4)
            glGetIntegerv(GL_VIEWPORT, viewport)
            val (x, y, w, h) = List(4) {
                viewport[it] * (if (it % 2 == 0) window.width else window.height) /
                    (if (it % 2 == 0) width else height)
            }
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, window.name)
            glViewport(x, y, w, h)
            block()
            glViewport(viewport[0], viewport[1], viewport[2], viewport[3])
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name)
        }
    }

    /** Whether a draw that samples [textures] shows the scene; where it draws that shows it then, too. */
    fun isShowing(textures: Collection<Int>): Boolean {
        if (textures.none { it in shown }) return false
        if (!window.isDrawnTo()) texture()?.let(shown::add)
        return true
    }

    /** Notes that the framebuffer read from is copied to the one drawn to; answers whether that shows the scene in the window. */
    fun copies(): Boolean {
        if (!hasScene || glGetInteger(GL_READ_FRAMEBUFFER_BINDING) != target) return false
        if (window.isDrawnTo()) return true
        texture()?.let(shown::add)
        return false
    }

    /** Notes a draw into the window that shows nothing of the scene; answers whether the scene turns out to be a mirror by it. */
    fun isSecondScene(): Boolean {
        if (!hasScene || !glIsEnabled(GL_DEPTH_TEST) || glGetInteger(GL_CURRENT_PROGRAM) !in programs) return false
        isMirror = true
        target = 0
        shown.clear()
        return true
    }

    private fun isForScene(): Boolean {
        if (glGetInteger(GL_DRAW_BUFFER0) == GL_NONE || glGetInteger(GL_DRAW_BUFFER1) != GL_NONE) return false
        if (attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return false
        val (width, height) = size() ?: return false
        val shape = width.toDouble() * window.height / (height.toDouble() * window.width)
        return 2 * width >= window.width && shape in SAME_SHAPE
    }

    /** The texture that is drawn to; null where it is none. */
    private fun texture(): Int? =
        if (attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_TEXTURE) {
            attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)
        } else {
            null
        }

    private fun size(): Pair<Int, Int>? =
        when (attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE)) {
            GL_TEXTURE -> ofTexture(attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME))
            GL_RENDERBUFFER -> ofRenderbuffer(attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME))
            else -> null
        }?.takeIf { it.first > 0 && it.second > 0 }

    private fun ofTexture(name: Int): Pair<Int, Int> {
        // Which kind it is nobody tells: as one of the other kind it cannot be bound.
        for ((kind, binding) in KINDS) {
            val before = glGetInteger(binding)
            glBindTexture(kind, name)
            if (glGetError() != GL_NO_ERROR) continue
            val size = glGetTexLevelParameteri(kind, 0, GL_TEXTURE_WIDTH) to glGetTexLevelParameteri(kind, 0, GL_TEXTURE_HEIGHT)
            glBindTexture(kind, before)
            return size
        }
        return 0 to 0
    }

    private fun ofRenderbuffer(name: Int): Pair<Int, Int> {
        val before = glGetInteger(GL_RENDERBUFFER_BINDING)
        glBindRenderbuffer(GL_RENDERBUFFER, name)
        val size = glGetRenderbufferParameteri(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH) to
            glGetRenderbufferParameteri(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT)
        glBindRenderbuffer(GL_RENDERBUFFER, before)
        return size
    }

    private fun attachment(
        point: Int,
        what: Int,
    ) = glGetFramebufferAttachmentParameteri(GL_DRAW_FRAMEBUFFER, point, what)

    private companion object {
        val SAME_SHAPE = 0.8..1.25
        val KINDS = mapOf(
            GL_TEXTURE_2D to GL_TEXTURE_BINDING_2D,
            GL_TEXTURE_2D_MULTISAMPLE to GL_TEXTURE_BINDING_2D_MULTISAMPLE,
        )
    }
}

package cga.grading.worker

import cga.coach.calls.Call
import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil

/** Lets [window] appear as framebuffer 0 with a back buffer. */
internal class FramebufferCalls(
    private val tape: Tape,
    private val window: WindowFramebuffer,
    private val scene: SceneTarget,
) {
    /** Does [call] where it is about framebuffers; answers false for all others. */
    fun handle(call: Call): Boolean {
        when (call.name) {
            "glBindFramebuffer" -> bind(call)
            "glGetIntegerv" -> get(call)
            "glDrawBuffer" -> if (window.isDrawnTo()) withBackBuffer(call, 0) else call.proceed()
            "glReadBuffer" -> if (window.isReadFrom()) withBackBuffer(call, 0) else call.proceed()
            "glDrawBuffers" -> if (window.isDrawnTo()) drawBuffers(call) else call.proceed()
            "glReadPixels" -> if (window.isReadFrom()) window.readable(call::proceed) else call.proceed()
            "glBlitFramebuffer" -> blit(call)
            else -> return false
        }
        return true
    }

    private fun bind(call: Call) {
        if (call.int(1) == 0) call.setInt(1, window.name)
        call.proceed()
    }

    private fun blit(call: Call) {
        if (scene.copies()) return tape.event(EventKind.NOT_CAPTURED, Recorder.LAID_BARE)
        if (window.isDrawnTo()) tape.event(EventKind.NOT_CAPTURED, "glBlitFramebuffer into the window")
        call.proceed()
    }

    private fun get(call: Call) {
        call.proceed()
        val value = MemoryUtil.memGetInt(call.long(1))
        val shown =
            when (call.int(0)) {
                GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING -> if (value == window.name) 0 else value
                GL_DRAW_BUFFER, GL_DRAW_BUFFER0 -> if (window.isDrawnTo()) back(value) else value
                GL_READ_BUFFER -> if (window.isReadFrom()) back(value) else value
                else -> value
            }
        if (shown != value) MemoryUtil.memPutInt(call.long(1), shown)
    }

    private fun back(value: Int) = if (value == GL_COLOR_ATTACHMENT0) GL_BACK else value

    private fun withBackBuffer(
        call: Call,
        index: Int,
    ) {
        call.setInt(index, attachment(call.int(index)))
        call.proceed()
    }

    private fun drawBuffers(call: Call) {
        val count = call.int(0)
        if (count !in 1..MAX_BUFFERS) return call.proceed()
        MemoryStack.stackPush().use { stack ->
            val names = stack.mallocInt(count)
            for (i in 0 until count) names.put(i, attachment(MemoryUtil.memGetInt(call.long(1) + i * Int.SIZE_BYTES)))
            call.setLong(1, MemoryUtil.memAddress(names))
            call.proceed()
        }
    }

    // There is one colour buffer; which of the window's names it goes by makes no difference.
    private fun attachment(name: Int) =
        if (name in GL_FRONT_LEFT..GL_BACK_RIGHT || name in GL_FRONT..GL_BACK || name == GL_FRONT_AND_BACK) GL_COLOR_ATTACHMENT0 else name

    private companion object {
        const val MAX_BUFFERS = 8
    }
}

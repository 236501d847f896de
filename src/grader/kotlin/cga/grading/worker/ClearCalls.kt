package cga.grading.worker

import cga.coach.calls.Call
import cga.grading.capture.CapturedClear
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil

/** Reads what the functions clear that do. */
internal object ClearCalls {
    /** What [call] clears, null for nothing that a picture shows. */
    fun step(call: Call): CapturedClear? {
        val clear =
            when (call.name) {
                "glClear" -> CapturedClear(call.int(0), color(), depth())
                "glClearBufferfv" -> buffer(call)
                "glClearBufferfi" -> CapturedClear(GL_DEPTH_BUFFER_BIT or GL_STENCIL_BUFFER_BIT, color(), call.float(2).toDouble())
                else -> null
            } ?: return null
        if (clear.mask and ALL.inv() != 0) return null
        // What may not be written is not cleared either.
        val mask = if (glGetBoolean(GL_DEPTH_WRITEMASK)) clear.mask else clear.mask and GL_DEPTH_BUFFER_BIT.inv()
        return CapturedClear(mask, clear.color, clear.depth.coerceIn(0.0, 1.0), State.writes())
    }

    private fun buffer(call: Call): CapturedClear? =
        when (call.int(0)) {
            GL_COLOR if call.int(1) == 0 -> CapturedClear(GL_COLOR_BUFFER_BIT, floats(call.long(2), 4), 1.0)
            GL_DEPTH -> CapturedClear(GL_DEPTH_BUFFER_BIT, FloatArray(4), floats(call.long(2), 1)[0].toDouble())
            else -> null
        }

    private fun floats(
        address: Long,
        count: Int,
    ) = FloatArray(count) { MemoryUtil.memGetFloat(address + it * Float.SIZE_BYTES) }

    private fun color(): FloatArray =
        MemoryStack.stackPush().use { stack ->
            val four = stack.mallocFloat(4)
            glGetFloatv(GL_COLOR_CLEAR_VALUE, four)
            FloatArray(4) { four[it] }
        }

    private fun depth(): Double = glGetDouble(GL_DEPTH_CLEAR_VALUE)

    private const val ALL = GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT or GL_STENCIL_BUFFER_BIT
}

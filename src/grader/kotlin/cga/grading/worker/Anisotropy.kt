package cga.grading.worker

import cga.coach.calls.Call
import cga.grading.capture.EventKind
import org.lwjgl.opengl.EXTTextureFilterAnisotropic.GL_TEXTURE_MAX_ANISOTROPY_EXT
import org.lwjgl.system.MemoryUtil

/**
 * Takes anisotropic filtering out of what a submission asks for: software rendering takes ten times as long with it, and without mipmaps it can
 * hang. What was asked for is noted.
 */
internal class Anisotropy(private val tape: Tape) {
    private val one = MemoryUtil.memAlloc(Float.SIZE_BYTES)

    /** To be called before each [call]. */
    fun limit(call: Call) {
        val kind = call.name.removePrefix("glTexParameter").removePrefix("glSamplerParameter")
        if (kind.length > 2 || call.int(1) != GL_TEXTURE_MAX_ANISOTROPY_EXT) return
        val asked =
            when (kind) {
                "f" -> call.float(2)
                "i" -> call.int(2).toFloat()
                "fv" -> MemoryUtil.memGetFloat(call.long(2))
                else -> MemoryUtil.memGetInt(call.long(2)).toFloat()
            }
        // What is no anisotropy is an error, and the driver says so.
        if (!(asked > 1f)) return
        tape.event(EventKind.ANISOTROPY, "$asked")
        when (kind) {
            "f" -> call.setFloat(2, 1f)
            "i" -> call.setInt(2, 1)
            "fv" -> call.setLong(2, MemoryUtil.memAddress(one.putFloat(0, 1f)))
            else -> call.setLong(2, MemoryUtil.memAddress(one.putInt(0, 1)))
        }
    }
}

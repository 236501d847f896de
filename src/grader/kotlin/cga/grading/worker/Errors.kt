package cga.grading.worker

import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.*

/**
 * Notes OpenGL's errors with the function that caused them, and keeps the first for the submission's own glGetError.
 */
internal class Errors(
    private val tape: Tape,
    private val callers: Callers,
) {
    private var pending = GL_NO_ERROR

    /** Looks for an error after [function]; answers whether there was one. */
    fun check(function: String): Boolean {
        val code = glGetError()
        if (code == GL_NO_ERROR) return false
        tape.event(EventKind.GL_ERROR, "${name(code)} $function", callers.now())
        if (pending == GL_NO_ERROR) pending = code
        return true
    }

    /** Forgets an error that our own question caused. */
    fun drop() {
        glGetError()
    }

    /** What the submission's glGetError is answered. */
    fun take(): Int {
        check("(a function before glGetError)")
        return pending.also { pending = GL_NO_ERROR }
    }

    private fun name(code: Int): String =
        when (code) {
            GL_INVALID_ENUM -> "GL_INVALID_ENUM"
            GL_INVALID_VALUE -> "GL_INVALID_VALUE"
            GL_INVALID_OPERATION -> "GL_INVALID_OPERATION"
            GL_INVALID_FRAMEBUFFER_OPERATION -> "GL_INVALID_FRAMEBUFFER_OPERATION"
            GL_OUT_OF_MEMORY -> "GL_OUT_OF_MEMORY"
            else -> "error $code"
        }
}

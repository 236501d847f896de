package cga.framework

import org.lwjgl.opengl.GL33C.*

/** Turns OpenGL's error flag into an exception that says what was being done. */
public object GLError {
    /**
     * Throws [IllegalStateException] naming every pending error of the current context; [action] completes "while …".
     * Running out of memory is the machine's limit and no mistake in the program: an [InputError].
     */
    public fun check(action: String) {
        var code = glGetError()
        if (code == GL_NO_ERROR) return
        val codes = mutableListOf<Int>()
        // A lost context answers errors for ever: a handful is enough to name.
        while (code != GL_NO_ERROR && codes.size < 8) {
            codes += code
            code = glGetError()
        }
        if (GL_OUT_OF_MEMORY in codes) {
            throw InputError("OpenGL ran out of memory while $action: give a smaller size, or fewer samples.")
        }
        error("OpenGL reported ${codes.joinToString(transform = ::name)} while $action.")
    }

    private fun name(code: Int): String =
        when (code) {
            GL_INVALID_ENUM -> "GL_INVALID_ENUM"
            GL_INVALID_VALUE -> "GL_INVALID_VALUE"
            GL_INVALID_OPERATION -> "GL_INVALID_OPERATION"
            GL_INVALID_FRAMEBUFFER_OPERATION -> "GL_INVALID_FRAMEBUFFER_OPERATION"
            GL_OUT_OF_MEMORY -> "GL_OUT_OF_MEMORY"
            else -> "error 0x%X".format(code)
        }
}

package cga.framework

import org.lwjgl.opengl.GL11.*
import org.lwjgl.opengl.GL30.GL_INVALID_FRAMEBUFFER_OPERATION

object GLError {
    /** Throws when one of the OpenGL calls since the last check failed. */
    fun checkThrow(where: String = "") {
        val error = glGetError()
        if (error != GL_NO_ERROR) throw Exception("OpenGL error ${name(error)} $where")
    }

    private fun name(error: Int) = when (error) {
        GL_INVALID_ENUM -> "GL_INVALID_ENUM"
        GL_INVALID_VALUE -> "GL_INVALID_VALUE"
        GL_INVALID_OPERATION -> "GL_INVALID_OPERATION"
        GL_OUT_OF_MEMORY -> "GL_OUT_OF_MEMORY"
        GL_INVALID_FRAMEBUFFER_OPERATION -> "GL_INVALID_FRAMEBUFFER_OPERATION"
        else -> "$error"
    }
}

package cga.grading.worker

import cga.coach.calls.Call
import org.lwjgl.opengl.GL33C.*

/** Notes which objects a call has written to. */
internal class WriteCalls(
    private val buffers: Writes,
    private val textures: Writes,
) {
    /** To be called after [call]. */
    fun note(call: Call) {
        when (call.name) {
            "glBufferData", "glBufferSubData", "glMapBuffer", "glMapBufferRange", "glUnmapBuffer" -> buffer(call.int(0))
            "glCopyBufferSubData" -> buffer(call.int(1))
            "glTexImage2D", "glTexSubImage2D", "glCopyTexImage2D", "glCopyTexSubImage2D", "glTexStorage2D", "glGenerateMipmap" ->
                texture(call.int(0))
            "glTexParameteri", "glTexParameteriv" -> if (call.int(1) in LEVELS) texture(call.int(0))
            // The names may come again for other objects.
            "glDeleteBuffers" -> buffers.noteAll()
            "glDeleteTextures" -> textures.noteAll()
        }
    }

    /** Something was drawn into a framebuffer of the submission's own, and that may be a texture. */
    fun noteDrawing(): Unit = textures.noteAll()

    private fun texture(target: Int) = textures.note(glGetInteger(TextureTarget.written(target).binding))

    private fun buffer(target: Int) {
        val binding = BINDINGS[target]
        if (binding == null) buffers.noteAll() else buffers.note(glGetInteger(binding))
    }

    private companion object {
        val LEVELS = setOf(GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL)
        val BINDINGS =
            mapOf(
                GL_ARRAY_BUFFER to GL_ARRAY_BUFFER_BINDING,
                GL_ELEMENT_ARRAY_BUFFER to GL_ELEMENT_ARRAY_BUFFER_BINDING,
                GL_COPY_READ_BUFFER to GL_COPY_READ_BUFFER,
                GL_COPY_WRITE_BUFFER to GL_COPY_WRITE_BUFFER,
                GL_UNIFORM_BUFFER to GL_UNIFORM_BUFFER_BINDING,
            )
    }
}

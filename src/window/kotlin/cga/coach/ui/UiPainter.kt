package cga.coach.ui

import org.lwjgl.nuklear.NkBuffer
import org.lwjgl.nuklear.NkContext
import org.lwjgl.nuklear.NkConvertConfig
import org.lwjgl.nuklear.NkDrawVertexLayoutElement
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil

/** Draws what a Nuklear context holds, over the picture that is there. Owned by [Ui]; made and used with the OpenGL context current. */
internal class UiPainter(
    private val context: NkContext,
    private val commands: NkBuffer,
    private val font: UiFont,
) : AutoCloseable {
    private val program = UiProgram()
    private val vertices = MemoryUtil.memAlloc(MAX_VERTEX_BYTES)
    private val indices = MemoryUtil.memAlloc(MAX_INDEX_BYTES)
    private val layout =
        NkDrawVertexLayoutElement.calloc(4).also {
            it[0].attribute(NK_VERTEX_POSITION).format(NK_FORMAT_FLOAT).offset(0)
            it[1].attribute(NK_VERTEX_TEXCOORD).format(NK_FORMAT_FLOAT).offset(8)
            it[2].attribute(NK_VERTEX_COLOR).format(NK_FORMAT_R8G8B8A8).offset(16)
            it[3].attribute(NK_VERTEX_ATTRIBUTE_COUNT).format(NK_FORMAT_COUNT).offset(0)
        }
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()
    private val ibo = glGenBuffers()

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, ibo)
        glVertexAttribPointer(0, 2, GL_FLOAT, false, VERTEX_BYTES, 0)
        glVertexAttribPointer(1, 2, GL_FLOAT, false, VERTEX_BYTES, 8)
        glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, true, VERTEX_BYTES, 16)
        for (location in 0..2) glEnableVertexAttribArray(location)
        glBindVertexArray(0)
    }

    /** Draws into the framebuffer that is bound, [ratio] of whose pixels are a unit of the window of [width]×[height]; the context is empty after. */
    fun paint(
        width: Int,
        height: Int,
        ratio: Float,
    ) {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        if (convert()) {
            glBufferData(GL_ARRAY_BUFFER, vertices, GL_STREAM_DRAW)
            glBufferData(GL_ELEMENT_ARRAY_BUFFER, indices, GL_STREAM_DRAW)
            enableState()
            program.use(width.toFloat(), height.toFloat())
            drawCommands(height, ratio)
            disableState()
        }
        glBindVertexArray(0)
        nk_clear(context)
        nk_buffer_clear(commands)
    }

    /** Fills the two buffers; false where the panel is too much for them, which is then not drawn. */
    private fun convert(): Boolean =
        MemoryStack.stackPush().use { stack ->
            val config =
                NkConvertConfig
                    .calloc(stack)
                    .vertex_layout(layout)
                    .vertex_size(VERTEX_BYTES.toLong())
                    .vertex_alignment(4)
                    .tex_null(font.white)
                    .circle_segment_count(22)
                    .curve_segment_count(22)
                    .arc_segment_count(22)
                    .global_alpha(1f)
                    .shape_AA(NK_ANTI_ALIASING_ON)
                    .line_AA(NK_ANTI_ALIASING_ON)
            val vertexBuffer = NkBuffer.malloc(stack)
            val indexBuffer = NkBuffer.malloc(stack)
            nk_buffer_init_fixed(vertexBuffer, vertices.clear())
            nk_buffer_init_fixed(indexBuffer, indices.clear())
            val result = nk_convert(context, commands, vertexBuffer, indexBuffer, config)
            vertices.limit(vertexBuffer.allocated().toInt())
            indices.limit(indexBuffer.allocated().toInt())
            result == NK_CONVERT_SUCCESS
        }

    private fun drawCommands(
        height: Int,
        ratio: Float,
    ) {
        var offset = 0L
        var command = nk__draw_begin(context, commands)
        while (command != null) {
            val count = command.elem_count()
            if (count > 0) {
                val clip = command.clip_rect()
                glBindTexture(GL_TEXTURE_2D, command.texture().id())
                glScissor(
                    (clip.x() * ratio).toInt(),
                    ((height - (clip.y() + clip.h())) * ratio).toInt(),
                    (clip.w().coerceAtLeast(0f) * ratio).toInt(),
                    (clip.h().coerceAtLeast(0f) * ratio).toInt(),
                )
                glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, offset)
                offset += 2L * count
            }
            command = nk__draw_next(command, commands, context)
        }
    }

    private fun enableState() {
        glActiveTexture(GL_TEXTURE0)
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        glDisable(GL_CULL_FACE)
        glDisable(GL_DEPTH_TEST)
        glEnable(GL_SCISSOR_TEST)
    }

    // What the scene expects and does not set itself.
    private fun disableState() {
        glDisable(GL_BLEND)
        glDisable(GL_SCISSOR_TEST)
    }

    override fun close() {
        program.close()
        glDeleteVertexArrays(vao)
        glDeleteBuffers(vbo)
        glDeleteBuffers(ibo)
        layout.free()
        MemoryUtil.memFree(vertices)
        MemoryUtil.memFree(indices)
    }

    private companion object {
        const val VERTEX_BYTES = 20
        const val MAX_VERTEX_BYTES = 1 shl 20
        const val MAX_INDEX_BYTES = 1 shl 18
    }
}

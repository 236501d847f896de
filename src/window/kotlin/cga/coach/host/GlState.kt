package cga.coach.host

import org.lwjgl.opengl.GL33C.*

/**
 * What OpenGL has been told and goes on to obey: so much of it as panels change, or as a program sets once, at its start. Read and set with
 * the context current.
 */
internal class GlState {
    private val switches = BooleanArray(SWITCHES.size)
    private val numbers = IntArray(NUMBERS.size)
    private val viewport = IntArray(4)
    private val scissor = IntArray(4)
    private val colorMask = IntArray(4)
    private val clearColor = FloatArray(4)
    private var texture = 0
    private var sampler = 0

    /** Remembers the present state. */
    fun read(): GlState {
        for (i in SWITCHES.indices) switches[i] = glIsEnabled(SWITCHES[i])
        for (i in NUMBERS.indices) numbers[i] = glGetInteger(NUMBERS[i])
        glGetIntegerv(GL_VIEWPORT, viewport)
        glGetIntegerv(GL_SCISSOR_BOX, scissor)
        glGetIntegerv(GL_COLOR_WRITEMASK, colorMask)
        glGetFloatv(GL_COLOR_CLEAR_VALUE, clearColor)
        glActiveTexture(GL_TEXTURE0)
        texture = glGetInteger(GL_TEXTURE_BINDING_2D)
        sampler = glGetInteger(GL_SAMPLER_BINDING)
        glActiveTexture(number(GL_ACTIVE_TEXTURE))
        return this
    }

    /** Brings the remembered state back. */
    fun apply() {
        for (i in SWITCHES.indices) if (switches[i]) glEnable(SWITCHES[i]) else glDisable(SWITCHES[i])
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3])
        glScissor(scissor[0], scissor[1], scissor[2], scissor[3])
        glColorMask(colorMask[0] != 0, colorMask[1] != 0, colorMask[2] != 0, colorMask[3] != 0)
        glClearColor(clearColor[0], clearColor[1], clearColor[2], clearColor[3])
        applyBindings()
        glBlendFuncSeparate(number(GL_BLEND_SRC_RGB), number(GL_BLEND_DST_RGB), number(GL_BLEND_SRC_ALPHA), number(GL_BLEND_DST_ALPHA))
        glBlendEquationSeparate(number(GL_BLEND_EQUATION_RGB), number(GL_BLEND_EQUATION_ALPHA))
        glDepthFunc(number(GL_DEPTH_FUNC))
        glDepthMask(number(GL_DEPTH_WRITEMASK) != 0)
        glCullFace(number(GL_CULL_FACE_MODE))
        glFrontFace(number(GL_FRONT_FACE))
        glPolygonMode(GL_FRONT_AND_BACK, number(GL_POLYGON_MODE))
        for (alignment in ALIGNMENTS) glPixelStorei(alignment, number(alignment))
    }

    private fun applyBindings() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, number(GL_DRAW_FRAMEBUFFER_BINDING))
        glBindFramebuffer(GL_READ_FRAMEBUFFER, number(GL_READ_FRAMEBUFFER_BINDING))
        glUseProgram(number(GL_CURRENT_PROGRAM))
        glBindVertexArray(number(GL_VERTEX_ARRAY_BINDING))
        glBindBuffer(GL_ARRAY_BUFFER, number(GL_ARRAY_BUFFER_BINDING))
        glActiveTexture(GL_TEXTURE0)
        glBindTexture(GL_TEXTURE_2D, texture)
        glBindSampler(0, sampler)
        glActiveTexture(number(GL_ACTIVE_TEXTURE))
    }

    private fun number(name: Int) = numbers[NUMBERS.indexOf(name)]

    companion object {
        private val SWITCHES =
            intArrayOf(
                GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DITHER, GL_MULTISAMPLE, GL_FRAMEBUFFER_SRGB,
                GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP, GL_RASTERIZER_DISCARD, GL_PRIMITIVE_RESTART, GL_SAMPLE_ALPHA_TO_COVERAGE,
            )
        private val ALIGNMENTS = intArrayOf(GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH)
        private val NUMBERS =
            intArrayOf(
                GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING,
                GL_ARRAY_BUFFER_BINDING, GL_ACTIVE_TEXTURE, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA,
                GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK, GL_CULL_FACE_MODE, GL_FRONT_FACE,
                GL_POLYGON_MODE,
            ) + ALIGNMENTS

        /** Switches off what would get in the way of panels, in the window's own framebuffer. */
        fun setForPanels() {
            for (switch in SWITCHES) if (switch != GL_MULTISAMPLE) glDisable(switch)
            glBindFramebuffer(GL_FRAMEBUFFER, 0)
            glColorMask(true, true, true, true)
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
            glBlendEquation(GL_FUNC_ADD)
            glBindSampler(0, 0)
            for (alignment in intArrayOf(GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT)) glPixelStorei(alignment, PLAIN_ALIGNMENT)
            glPixelStorei(GL_UNPACK_ROW_LENGTH, 0)
        }

        private const val PLAIN_ALIGNMENT = 4
    }
}

package cga.grading.replay

import cga.framework.RenderTarget
import cga.grading.capture.Capture
import cga.grading.capture.CapturedClear
import cga.grading.capture.CapturedDraw
import cga.grading.capture.DrawState
import cga.grading.capture.WriteMask
import org.lwjgl.opengl.GL33C.*

/**
 * Draws the frames of a [Capture] again, as they were or with a [Change]. Needs a current OpenGL 3.3 context, owns what it makes in it, and
 * leaves the context's state as a draw leaves it.
 *
 * On the same OpenGL, into a target of the capture's size and samples, an unchanged frame has the worker's bytes.
 *
 * @param capture as [cga.grading.capture.CaptureFile] read it: checked, that is.
 */
public class Replay(public val capture: Capture) : AutoCloseable {
    private val objects = ReplayObjects(capture)
    private val vertexArray = glGenVertexArrays()

    /**
     * Draws frame number [frame] into [target], which may have any size: the viewport is scaled with it. Throws [ReplayError].
     */
    public fun draw(
        frame: Int,
        target: RenderTarget,
        change: Change = Change.NONE,
    ) {
        target.bind()
        reset()
        capture.frames[frame].steps.forEachIndexed { number, step ->
            when (step) {
                is CapturedClear -> clear(step, target)
                is CapturedDraw -> if (change.isDrawn(number, step)) draw(number, step, target, change)
            }
        }
        glBindVertexArray(0)
        set(WriteMask.ALL, target)
        val error = glGetError()
        if (error != GL_NO_ERROR) throw ReplayError("OpenGL reported error 0x%X in frame %d of the capture".format(error, frame))
    }

    override fun close() {
        objects.close()
        glDeleteVertexArrays(vertexArray)
    }

    /** What every frame begins with, in the worker too. */
    private fun reset() {
        // A lost context answers errors for ever.
        repeat(MAX_ERRORS) { glGetError() }
        glDisable(GL_SCISSOR_TEST)
        glDepthMask(true)
        glColorMask(true, true, true, true)
        glClearColor(0f, 0f, 0f, 0f)
        glClearDepth(1.0)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
    }

    private fun clear(
        clear: CapturedClear,
        target: RenderTarget,
    ) {
        glDepthMask(true)
        set(clear.writes, target)
        glClearColor(clear.color[0], clear.color[1], clear.color[2], clear.color[3])
        glClearDepth(clear.depth)
        glClear(clear.mask)
    }

    private fun draw(
        number: Int,
        draw: CapturedDraw,
        target: RenderTarget,
        change: Change,
    ) {
        val program = objects.program(change.program(number, draw, capture.programs[draw.program]))
        glUseProgram(program.name)
        for (uniform in draw.uniforms) program.set(uniform, change.numbers(number, draw, uniform))
        bindTextures(number, draw, change)
        set(draw.state, target)
        bindVertices(draw)
        if (draw.indices == null) {
            glDrawArraysInstanced(draw.mode, draw.first.toInt(), draw.count, draw.instances)
        } else {
            glDrawElementsInstancedBaseVertex(draw.mode, draw.count, draw.indexType, draw.first, draw.instances, draw.baseVertex)
        }
        for (attribute in draw.attributes) glDisableVertexAttribArray(attribute.location)
        for (unit in draw.textures.keys) {
            glActiveTexture(GL_TEXTURE0 + unit)
            glBindTexture(GL_TEXTURE_2D, 0)
            glBindTexture(GL_TEXTURE_CUBE_MAP, 0)
        }
    }

    private fun bindTextures(
        number: Int,
        draw: CapturedDraw,
        change: Change,
    ) {
        for ((unit, texture) in draw.textures) {
            glActiveTexture(GL_TEXTURE0 + unit)
            val picture = change.texture(number, draw, unit)
            if (picture != null) objects.bindPicture(picture) else objects.bindTexture(texture)
        }
    }

    private fun bindVertices(draw: CapturedDraw) {
        glBindVertexArray(vertexArray)
        for (attribute in draw.attributes) {
            glBindBuffer(GL_ARRAY_BUFFER, objects.buffer(attribute.buffer))
            glEnableVertexAttribArray(attribute.location)
            glVertexAttribPointer(
                attribute.location, attribute.size, attribute.type, attribute.normalized, attribute.stride, attribute.offset,
            )
        }
        draw.indices?.let { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, objects.buffer(it)) }
    }

    private fun set(
        state: DrawState,
        target: RenderTarget,
    ) {
        val (x, y, width, height) = scaled(state.viewport, target)
        glViewport(x, y, width, height)
        set(state.writes, target)
        enable(GL_DEPTH_TEST, state.depthTest)
        glDepthFunc(state.depthFunc)
        glDepthMask(state.depthMask)
        enable(GL_CULL_FACE, state.cullFace)
        glCullFace(state.cullMode)
        glFrontFace(state.frontFace)
        enable(GL_BLEND, state.blend)
        glBlendFunc(state.blendSource, state.blendDestination)
        glPolygonMode(GL_FRONT_AND_BACK, state.polygonMode)
        enable(GL_FRAMEBUFFER_SRGB, state.framebufferSrgb)
    }

    private fun set(
        writes: WriteMask,
        target: RenderTarget,
    ) {
        glColorMask(writes.may(0), writes.may(1), writes.may(2), writes.may(3))
        enable(GL_SCISSOR_TEST, writes.scissor != null)
        val (x, y, width, height) = scaled(writes.scissor ?: return, target)
        glScissor(x, y, width, height)
    }

    private fun WriteMask.may(channel: Int) = channels shr channel and 1 != 0

    private fun scaled(
        box: List<Int>,
        target: RenderTarget,
    ) = box.mapIndexed { i, number -> if (i % 2 == 0) number * target.width / capture.width else number * target.height / capture.height }

    private fun enable(
        switch: Int,
        on: Boolean,
    ): Unit = if (on) glEnable(switch) else glDisable(switch)

    private companion object {
        const val MAX_ERRORS = 8
    }
}

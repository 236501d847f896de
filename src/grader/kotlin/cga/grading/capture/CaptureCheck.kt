package cga.grading.capture

import org.lwjgl.opengl.GL33C.*

/**
 * Whether the parts of a capture fit together: references lead somewhere, levels and pictures have the size that they claim, constants are
 * ones that OpenGL takes in that place, and no draw reads outside of its buffers.
 */
internal class CaptureCheck(private val capture: Capture) {
    private val largest = HashMap<List<Any>, Long>()
    private var indicesLeft = CaptureLimits.INDICES

    /** Throws [BadCapture] at the first thing that does not fit. */
    fun check() {
        capture.textures.forEach(::check)
        for (call in capture.callers.flatten()) expect(call.length <= CaptureLimits.CALL) { "a call has ${call.length} characters" }
        var steps = 0
        for (frame in capture.frames) {
            steps += frame.steps.size
            expect(steps <= CaptureLimits.ALL_STEPS) { "the frames have more than ${CaptureLimits.ALL_STEPS} steps" }
            expect(frame.picture == null || frame.picture.size == 4 * capture.width * capture.height) { "a picture has the wrong size" }
            frame.steps.forEach {
                when (it) {
                    is CapturedClear -> check(it)
                    is CapturedDraw -> check(it)
                }
            }
        }
        for (event in capture.events) {
            expect(event.frame < maxOf(capture.frames.size, 1)) { "an event belongs to frame ${event.frame}, which is not there" }
            caller(event.caller)
            expect(event.text.length <= CaptureLimits.EVENT_TEXT) { "an event has ${event.text.length} characters" }
        }
    }

    private fun check(texture: CapturedTexture) {
        expect(texture.levels.isNotEmpty()) { "a texture has no level" }
        texture.levels.forEachIndexed { level, texels ->
            val size = 4L * texture.faces * maxOf(1, texture.width shr level) * maxOf(1, texture.height shr level)
            expect(texels.size.toLong() == size) { "level $level of a ${texture.width}x${texture.height} texture has ${texels.size} bytes" }
        }
        expect(1 shl (texture.levels.size - 1) <= maxOf(texture.width, texture.height)) { "a texture has more levels than it can have" }
        expect(!texture.isCube || texture.width == texture.height) { "a cube map is ${texture.width}x${texture.height}" }
        expect(texture.depth == 0 || (texture.depth in DEPTHS && !texture.isCube)) { "a texture of depths has the format ${texture.depth}" }
        expect(texture.wrapS in WRAPS && texture.wrapT in WRAPS && texture.wrapR in WRAPS) { "a texture wraps in an unknown way" }
        expect(texture.magFilter == GL_NEAREST || texture.magFilter == GL_LINEAR) { "a texture's magFilter is ${texture.magFilter}" }
        val minFilters = GlNumbers.mipmapFilters + GL_NEAREST + GL_LINEAR
        expect(texture.minFilter in minFilters) { "a texture's minFilter is ${texture.minFilter}" }
        expect(texture.maxAnisotropy in 1f..16f) { "a texture's anisotropy is ${texture.maxAnisotropy}" }
    }

    private fun check(clear: CapturedClear) {
        expect(clear.mask and (GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT or GL_STENCIL_BUFFER_BIT).inv() == 0) {
            "a clear's mask is ${clear.mask}"
        }
        expect(clear.depth in 0.0..1.0) { "a clear's depth is ${clear.depth}" }
        check(clear.writes)
    }

    private fun check(draw: CapturedDraw) {
        expect(draw.program in capture.programs.indices) { "a draw's program is ${draw.program}" }
        expect(draw.mode in GlNumbers.modes) { "a draw's mode is ${draw.mode}" }
        expect(draw.textures.values.all { it in capture.textures.indices }) { "a draw's texture is not there" }
        expect(draw.uniforms.distinctBy { it.name }.size == draw.uniforms.size) { "two uniforms of a draw have one name" }
        expect(draw.attributes.distinctBy { it.location }.size == draw.attributes.size) { "two attributes of a draw have one location" }
        draw.callers.textures.values.forEach(::caller)
        draw.uniforms.forEach { caller(it.caller) }
        caller(draw.callers.draw)
        caller(draw.callers.program)
        check(draw.state)
        val last = lastVertex(draw)
        for (attribute in draw.attributes) {
            expect(attribute.buffer in capture.buffers.indices) { "an attribute's buffer is ${attribute.buffer}" }
            expect(DrawBounds.holds(attribute, last, capture.buffers[attribute.buffer].size)) {
                "a draw reads vertex $last outside of buffer ${attribute.buffer}"
            }
        }
    }

    private fun caller(number: Int) = expect(number < capture.callers.size) { "caller $number is not there" }

    /** The number of the last vertex that [draw] reads; −1 for none. */
    private fun lastVertex(draw: CapturedDraw): Long {
        if (draw.indices == null) {
            expect(draw.first in 0..Int.MAX_VALUE.toLong() && draw.baseVertex == 0) { "a draw begins at vertex ${draw.first}" }
            return draw.first + draw.count - 1
        }
        expect(draw.indices in capture.buffers.indices) { "a draw's index buffer is ${draw.indices}" }
        val bytes = GlNumbers.indexBytes(draw.indexType) ?: throw BadCapture("a draw's indices are of type ${draw.indexType}")
        expect(draw.baseVertex >= 0) { "a draw's base vertex is ${draw.baseVertex}" }
        val index =
            largest.getOrPut(listOf(draw.indices, draw.indexType, draw.first, draw.count)) {
                indicesLeft -= minOf(draw.count, capture.buffers[draw.indices].size)
                expect(indicesLeft >= 0) { "the draws have too many indices to look at" }
                DrawBounds.largestIndex(capture.buffers[draw.indices], bytes, draw.first, draw.count)
                    ?: throw BadCapture("a draw reads outside of index buffer ${draw.indices}")
            }
        return if (index < 0) -1 else index + draw.baseVertex
    }

    private fun check(writes: WriteMask) {
        expect(writes.channels in 0..WriteMask.ALL_CHANNELS) { "a mask of channels is ${writes.channels}" }
        val box = writes.scissor ?: return
        expect(box.size == SCISSOR && box[2] >= 0 && box[3] >= 0) { "a scissor box is $box" }
    }

    private fun check(state: DrawState) {
        check(state.writes)
        expect(state.viewport[2] >= 0 && state.viewport[3] >= 0) { "a viewport is ${state.viewport}" }
        expect(state.depthFunc in GL_NEVER..GL_ALWAYS) { "a depth function is ${state.depthFunc}" }
        expect(state.cullMode in setOf(GL_FRONT, GL_BACK, GL_FRONT_AND_BACK)) { "a cull mode is ${state.cullMode}" }
        expect(state.frontFace == GL_CW || state.frontFace == GL_CCW) { "a front face is ${state.frontFace}" }
        expect(state.polygonMode in setOf(GL_POINT, GL_LINE, GL_FILL)) { "a polygon mode is ${state.polygonMode}" }
        expect(state.blendSource in FACTORS && state.blendDestination in FACTORS) { "a blend factor is unknown" }
    }

    private inline fun expect(
        holds: Boolean,
        what: () -> String,
    ) {
        if (!holds) throw BadCapture(what())
    }

    private companion object {
        val WRAPS = setOf(GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER)
        const val SCISSOR = 4
        val DEPTHS = setOf(GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT32F)
        val FACTORS = setOf(GL_ZERO, GL_ONE) + (GL_SRC_COLOR..GL_SRC_ALPHA_SATURATE) + (GL_CONSTANT_COLOR..GL_ONE_MINUS_CONSTANT_ALPHA)
    }
}

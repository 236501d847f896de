package cga.grading.capture

import java.io.DataOutputStream

/** Writes the parts of a capture in the order in which [CaptureReader] reads them. */
internal class CaptureWriter(private val out: DataOutputStream) {
    fun write(capture: Capture) {
        out.writeInt(capture.width)
        out.writeInt(capture.height)
        out.writeInt(capture.samples)
        list(capture.programs, ::program)
        list(capture.buffers, ::bytes)
        list(capture.textures, ::texture)
        list(capture.frames, ::frame)
        list(capture.events) {
            out.writeByte(it.kind.ordinal)
            out.writeInt(it.frame)
            text(it.text)
            out.writeInt(it.caller)
        }
        list(capture.callers) { chain -> list(chain, ::text) }
    }

    private fun program(program: CapturedProgram) {
        text(program.vertexSource)
        text(program.fragmentSource)
        numbers(program.attributes)
        numbers(program.outputs)
        out.writeBoolean(program.substituted)
        text(program.vertexFile.orEmpty())
        text(program.fragmentFile.orEmpty())
    }

    private fun numbers(map: Map<String, Int>) {
        list(map.entries) {
            text(it.key)
            out.writeInt(it.value)
        }
    }

    private fun texture(texture: CapturedTexture) {
        out.writeInt(texture.width)
        out.writeInt(texture.height)
        list(texture.levels, ::bytes)
        for (number in listOf(texture.wrapS, texture.wrapT, texture.minFilter, texture.magFilter)) out.writeInt(number)
        out.writeFloat(texture.maxAnisotropy)
        val kinds = listOf(texture.srgb to SRGB, texture.isCube to CUBE, (texture.depth != 0) to DEPTH, (texture.border != null) to BORDER)
        out.writeByte(kinds.sumOf { (isSo, bit) -> if (isSo) bit else 0 })
        if (texture.isCube) out.writeInt(texture.wrapR)
        if (texture.depth != 0) out.writeInt(texture.depth)
        texture.border?.let { border -> repeat(COLOR) { out.writeFloat(border[it]) } }
    }

    private fun frame(frame: CapturedFrame) {
        out.writeByte(frame.moment.ordinal)
        out.writeDouble(frame.time)
        list(frame.steps) {
            when (it) {
                is CapturedClear -> clear(it)
                is CapturedDraw -> draw(it)
            }
        }
        out.writeBoolean(frame.picture != null)
        frame.picture?.let(::bytes)
    }

    private fun clear(clear: CapturedClear) {
        writes(clear.writes)
        out.writeByte(CLEAR)
        out.writeInt(clear.mask)
        repeat(COLOR) { out.writeFloat(clear.color[it]) }
        out.writeDouble(clear.depth)
    }

    private fun draw(draw: CapturedDraw) {
        writes(draw.state.writes)
        out.writeByte(DRAW)
        for (number in listOf(draw.program, draw.mode, draw.count)) out.writeInt(number)
        list(draw.attributes, ::attribute)
        out.writeInt(draw.indices ?: -1)
        out.writeInt(draw.indexType)
        out.writeLong(draw.first)
        out.writeInt(draw.baseVertex)
        out.writeInt(draw.instances)
        list(draw.uniforms) {
            text(it.name)
            out.writeInt(it.type)
            for (number in it.numbers) out.writeFloat(number)
            out.writeInt(it.caller)
        }
        units(draw.textures)
        state(draw.state)
        out.writeInt(draw.callers.draw)
        out.writeInt(draw.callers.program)
        units(draw.callers.textures)
    }

    private fun units(units: Map<Int, Int>) =
        list(units.entries) {
            out.writeInt(it.key)
            out.writeInt(it.value)
        }

    /** Nearly every step may write everywhere: what limits one stands before it. */
    private fun writes(mask: WriteMask) {
        if (mask == WriteMask.ALL) return
        out.writeByte(LIMITED)
        out.writeByte(mask.channels)
        list(mask.scissor.orEmpty(), out::writeInt)
    }

    private fun attribute(attribute: CapturedAttribute) {
        for (number in listOf(attribute.location, attribute.size, attribute.type)) out.writeInt(number)
        out.writeBoolean(attribute.normalized)
        out.writeInt(attribute.stride)
        out.writeLong(attribute.offset)
        out.writeInt(attribute.buffer)
    }

    private fun state(state: DrawState) {
        repeat(VIEWPORT) { out.writeInt(state.viewport[it]) }
        for (on in listOf(state.depthTest, state.depthMask, state.cullFace, state.blend, state.framebufferSrgb)) out.writeBoolean(on)
        for (
        number in listOf(
            state.depthFunc, state.cullMode, state.frontFace, state.blendSource, state.blendDestination, state.polygonMode,
        )
        ) {
            out.writeInt(number)
        }
    }

    private fun bytes(bytes: ByteArray) {
        out.writeInt(bytes.size)
        out.write(bytes)
    }

    private fun text(text: String): Unit = bytes(text.toByteArray())

    private fun <T> list(
        elements: Collection<T>,
        write: (T) -> Unit,
    ) {
        out.writeInt(elements.size)
        elements.forEach(write)
    }

    internal companion object {
        const val CLEAR = 0
        const val DRAW = 1
        const val LIMITED = 2
        const val SRGB = 1
        const val CUBE = 2
        const val DEPTH = 4
        const val BORDER = 8
        const val KINDS = SRGB or CUBE or DEPTH or BORDER
        const val COLOR = 4
        const val VIEWPORT = 4
    }
}

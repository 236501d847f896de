package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.CapturedAttribute
import cga.grading.capture.CapturedDraw
import cga.grading.capture.DrawBounds
import cga.grading.capture.EventKind
import cga.grading.capture.GlNumbers
import cga.grading.capture.UniformValue
import org.lwjgl.opengl.GL33C.*

/** Reads all that a draw is about to read. */
internal class Draws(
    private val tape: Tape,
    private val programs: Programs,
    private val callers: Callers,
) {
    val buffers: Buffers = Buffers(tape)
    val textures: Textures = Textures(tape)

    /**
     * What comes of looking at a draw.
     *
     * @param draw what goes on tape, null for nothing.
     * @param isSafe whether the driver may be handed it.
     */
    class Look(
        val draw: CapturedDraw?,
        val isSafe: Boolean,
    )

    /** Looks at [call], a call of [function], with the state of now. */
    fun look(
        call: DrawCall,
        function: String,
    ): Look {
        // What OpenGL refuses anyway it shall refuse itself, so that the submission sees the error.
        if (!isLegal(call)) return Look(null, true)
        val name = glGetInteger(GL_CURRENT_PROGRAM)
        val program = programs.find(name) ?: return refuse("$function without a program in use")
        val indices = if (call.indexType == 0) null else indices() ?: return refuse("$function without an index buffer")
        val last = lastVertex(call, indices) ?: return refuse("$function reads beyond its index buffer")
        val attributes = program.locations.filter(::isEnabled).map { attribute(it) ?: return refuse("$function: vertex attribute $it") }
        for (attribute in attributes) {
            if (!DrawBounds.holds(attribute, last, bytes(attribute))) {
                return refuse("$function reads vertex $last, beyond the buffer of vertex attribute ${attribute.location}")
            }
        }
        val values =
            program.uniforms.map { Uniforms.value(name, it, callers.ofUniform(name, it.location)) } + program.blocks.values(buffers)
        val number = program.number
        if (number == null || (indices != null && indices.number == null)) return refuse("$function of what a capture cannot hold", true)
        State.unusual()?.let { tape.event(EventKind.NOT_CAPTURED, "$function with $it") }
        val bound = textures(values)
        val draw =
            CapturedDraw(
                number, call.mode, call.count, attributes, indices?.number, call.indexType, call.first, call.baseVertex, call.instances,
                values, bound, State.read(), callers.ofDraw(bound.keys),
            )
        return Look(draw.takeIf { tape.affordStep(values.size + attributes.size + 1) }, true)
    }

    private fun isLegal(call: DrawCall) =
        call.mode in GlNumbers.modes && call.count >= 0 && call.instances in 0..CaptureLimits.INSTANCES && call.baseVertex >= 0 &&
            call.first >= 0 && (call.indexType == 0 || GlNumbers.indexBytes(call.indexType) != null) &&
            glGetInteger(GL_VERTEX_ARRAY_BINDING) != 0

    private fun refuse(
        what: String,
        isSafe: Boolean = false,
    ): Look {
        tape.event(EventKind.NOT_CAPTURED, what)
        return Look(null, isSafe)
    }

    private fun indices(): Buffers.Stored? = glGetInteger(GL_ELEMENT_ARRAY_BUFFER_BINDING).takeIf { it != 0 }?.let(buffers::contents)

    private fun lastVertex(
        call: DrawCall,
        indices: Buffers.Stored?,
    ): Long? {
        if (indices == null) return call.first + call.count - 1
        val largest = buffers.largestIndex(indices, call.indexType, call.first, call.count) ?: return null
        return if (largest < 0) -1 else largest + call.baseVertex
    }

    private fun isEnabled(location: Int) = glGetVertexAttribi(location, GL_VERTEX_ATTRIB_ARRAY_ENABLED) != 0

    /** The attribute as it is set; null when a capture cannot hold it. */
    private fun attribute(location: Int): CapturedAttribute? {
        val type = attribute(location, GL_VERTEX_ATTRIB_ARRAY_TYPE)
        val size = attribute(location, GL_VERTEX_ATTRIB_ARRAY_SIZE)
        val buffer = attribute(location, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)
        val isInteger = attribute(location, GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0
        val divisor = attribute(location, GL_VERTEX_ATTRIB_ARRAY_DIVISOR)
        if (buffer == 0 || isInteger || divisor != 0 || size !in 1..4 || GlNumbers.attributeBytes(type) == null) return null
        return CapturedAttribute(
            location, size, type, attribute(location, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED) != 0,
            attribute(location, GL_VERTEX_ATTRIB_ARRAY_STRIDE), glGetVertexAttribPointer(location, GL_VERTEX_ATTRIB_ARRAY_POINTER),
            buffers.contents(buffer).number ?: return null,
        )
    }

    private fun attribute(
        location: Int,
        what: Int,
    ) = glGetVertexAttribi(location, what)

    private fun bytes(attribute: CapturedAttribute) =
        buffers.contents(attribute(attribute.location, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)).bytes.size

    /** OpenGL's names of the textures that a draw would sample now. */
    fun sampled(): List<Int> {
        val name = glGetInteger(GL_CURRENT_PROGRAM)
        val samplers = programs.find(name)?.uniforms.orEmpty().filter { TextureTarget.ofSampler(it.type) == TextureTarget.FLAT }
        if (samplers.isEmpty()) return emptyList()
        val active = glGetInteger(GL_ACTIVE_TEXTURE)
        val units = samplers.map { Uniforms.value(name, it).numbers[0].toInt() }.filter { it in 0 until CaptureLimits.UNITS }
        val textures = units.map { unit ->
            glActiveTexture(GL_TEXTURE0 + unit)
            glGetInteger(GL_TEXTURE_BINDING_2D)
        }
        glActiveTexture(active)
        return textures
    }

    private fun textures(uniforms: List<UniformValue>): Map<Int, Int> {
        val samplers = uniforms.mapNotNull { uniform -> TextureTarget.ofSampler(uniform.type)?.let { uniform to it } }
        if (samplers.isEmpty()) return emptyMap()
        val active = glGetInteger(GL_ACTIVE_TEXTURE)
        val numbers = LinkedHashMap<Int, Int>()
        for ((sampler, target) in samplers) {
            val unit = sampler.numbers[0].toInt()
            if (unit !in 0 until CaptureLimits.UNITS || unit in numbers) continue
            glActiveTexture(GL_TEXTURE0 + unit)
            val name = glGetInteger(target.binding)
            if (name == 0) continue
            textures.number(name, target, sampler.name)?.let { numbers[unit] = it }
        }
        glActiveTexture(active)
        return numbers
    }
}

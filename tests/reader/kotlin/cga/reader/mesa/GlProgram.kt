package cga.reader.mesa

import cga.reader.OneColor
import cga.reader.shader.Kind
import cga.reader.shader.Slot
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack

/** The driver does not take a shader; the message is its log. */
internal class Refused(log: String) : RuntimeException(log)

/** A program of the driver's, to be set up with the numbers that a machine of the reader has. */
internal class GlProgram(vertex: String, fragment: String, beforeLink: (Int) -> Unit = {}) : AutoCloseable {
    val id = glCreateProgram()
    private val textures = ArrayList<Int>()
    private val buffers = HashMap<Int, Int>()

    init {
        for ((stage, text) in listOf(GL_VERTEX_SHADER to vertex, GL_FRAGMENT_SHADER to fragment)) attach(stage, text)
        beforeLink(id)
        glLinkProgram(id)
        if (glGetProgrami(id, GL_LINK_STATUS) == GL_FALSE) refuse(glGetProgramInfoLog(id))
        glUseProgram(id)
    }

    private fun attach(stage: Int, text: String) {
        val shader = glCreateShader(stage)
        glShaderSource(shader, text)
        glCompileShader(shader)
        val log = if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) glGetShaderInfoLog(shader) else null
        glAttachShader(id, shader)
        glDeleteShader(shader)
        if (log != null) refuse(log)
    }

    private fun refuse(log: String): Nothing {
        glDeleteProgram(id)
        throw Refused(log)
    }

    /** Sets a uniform, called [name] here; one that the driver found unused has no place. */
    fun set(slot: Slot, numbers: DoubleArray, name: String = slot.name) {
        val location = glGetUniformLocation(id, name)
        if (location < 0) return setInBlock(slot, numbers)
        val floats = FloatArray(numbers.size) { numbers[it].toFloat() }
        val ints = IntArray(numbers.size) { numbers[it].toLong().toInt() }
        when {
            slot.columns > 1 -> setMatrix(location, slot, floats)
            slot.kind == Kind.FLOAT -> setFloats(location, floats)
            slot.kind == Kind.UINT -> setUnsigned(location, ints)
            else -> setInts(location, ints)
        }
    }

    private fun setFloats(location: Int, numbers: FloatArray) =
        when (numbers.size) {
            1 -> glUniform1fv(location, numbers)
            2 -> glUniform2fv(location, numbers)
            3 -> glUniform3fv(location, numbers)
            else -> glUniform4fv(location, numbers)
        }

    private fun setInts(location: Int, numbers: IntArray) =
        when (numbers.size) {
            1 -> glUniform1iv(location, numbers)
            2 -> glUniform2iv(location, numbers)
            3 -> glUniform3iv(location, numbers)
            else -> glUniform4iv(location, numbers)
        }

    private fun setUnsigned(location: Int, numbers: IntArray) =
        when (numbers.size) {
            1 -> glUniform1uiv(location, numbers)
            2 -> glUniform2uiv(location, numbers)
            3 -> glUniform3uiv(location, numbers)
            else -> glUniform4uiv(location, numbers)
        }

    private fun setMatrix(location: Int, slot: Slot, floats: FloatArray) {
        when (slot.columns to slot.rows) {
            2 to 2 -> glUniformMatrix2fv(location, false, floats)
            3 to 3 -> glUniformMatrix3fv(location, false, floats)
            4 to 4 -> glUniformMatrix4fv(location, false, floats)
            else -> error("a matrix of ${slot.columns} columns and ${slot.rows} rows")
        }
    }

    private fun setInBlock(slot: Slot, numbers: DoubleArray) {
        // Of an array of basic types only the first is listed.
        val element = Regex("""(.*)\[(\d+)]""").matchEntire(slot.name)
        val index = glGetUniformIndices(id, element?.let { it.groupValues[1] + "[0]" } ?: slot.name)
        if (index == GL_INVALID_INDEX) return
        val block = glGetActiveUniformsi(id, index, GL_UNIFORM_BLOCK_INDEX)
        if (block < 0) return
        buffers.getOrPut(block) { newBuffer(block) }.let { glBindBuffer(GL_UNIFORM_BUFFER, it) }
        val before = if (element == null) 0 else element.groupValues[2].toInt() * glGetActiveUniformsi(id, index, GL_UNIFORM_ARRAY_STRIDE)
        val offset = glGetActiveUniformsi(id, index, GL_UNIFORM_OFFSET) + before
        val stride = glGetActiveUniformsi(id, index, GL_UNIFORM_MATRIX_STRIDE)
        for ((i, number) in numbers.withIndex()) {
            val at = (offset + i / slot.rows * maxOf(stride, 0) + i % slot.rows * Float.SIZE_BYTES).toLong()
            val bits = if (slot.kind == Kind.FLOAT) number.toFloat().toRawBits() else number.toLong().toInt()
            glBufferSubData(GL_UNIFORM_BUFFER, at, intArrayOf(bits))
        }
    }

    private fun newBuffer(block: Int): Int {
        val buffer = glGenBuffers()
        glBindBuffer(GL_UNIFORM_BUFFER, buffer)
        glBufferData(GL_UNIFORM_BUFFER, glGetActiveUniformBlocki(id, block, GL_UNIFORM_BLOCK_DATA_SIZE).toLong(), GL_STATIC_DRAW)
        glUniformBlockBinding(id, block, buffers.size)
        glBindBufferBase(GL_UNIFORM_BUFFER, buffers.size, buffer)
        return buffer
    }

    /** Gives a sampler a texture of one texel. */
    fun set(slot: Slot, color: OneColor) {
        val location = glGetUniformLocation(id, slot.name)
        if (location < 0) return
        val target = targets[typeOf(slot.name)] ?: error("no texture is made for ${slot.name}")
        val unit = textures.size
        glActiveTexture(GL_TEXTURE0 + unit)
        textures += glGenTextures()
        glBindTexture(target, textures.last())
        val texel = FloatArray(4) { color.rgba[it].toFloat() }
        val faces = if (target == GL_TEXTURE_CUBE_MAP) (0 until 6).map { GL_TEXTURE_CUBE_MAP_POSITIVE_X + it } else listOf(target)
        for (face in faces) glTexImage2D(face, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, texel)
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
        glUniform1i(location, unit)
    }

    private fun typeOf(name: String): Int =
        MemoryStack.stackPush().use { stack ->
            val index = glGetUniformIndices(id, name)
            val size = stack.mallocInt(1)
            val type = stack.mallocInt(1)
            glGetActiveUniform(id, index, size, type)
            type[0]
        }

    override fun close() {
        glDeleteProgram(id)
        for (texture in textures) glDeleteTextures(texture)
        for (buffer in buffers.values) glDeleteBuffers(buffer)
    }

    private companion object {
        val targets = mapOf(GL_SAMPLER_2D to GL_TEXTURE_2D, GL_SAMPLER_CUBE to GL_TEXTURE_CUBE_MAP)
    }
}

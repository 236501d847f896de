package cga.grading.worker

import cga.grading.capture.CaptureLimits
import cga.grading.capture.EventKind
import cga.grading.capture.GlNumbers
import cga.grading.capture.UniformValue
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * The uniforms that a linked program reads from buffers.
 *
 * @param members one for each element of an array, by the names that the program's [PlainUniforms] have for them.
 */
internal class UniformBlocks private constructor(
    private val program: Int,
    val members: List<Member>,
) {
    /**
     * One uniform in a block.
     *
     * @param offset in bytes, of its first number in the block.
     * @param stride in bytes, from column to column of a matrix, or from row to row where [isRowMajor].
     */
    class Member(
        val name: String,
        val type: Int,
        val block: Int,
        val offset: Int,
        val stride: Int,
        val isRowMajor: Boolean,
    )

    /** What the [buffers] that are bound now hold for each of the [members]; 0 where they end too early. */
    fun values(buffers: Buffers): List<UniformValue> {
        val blocks = members.map { it.block }.distinct().associateWith { block -> bound(block, buffers) }
        return members.map { UniformValue(it.name, it.type, numbers(it, blocks.getValue(it.block))) }
    }

    private fun bound(
        block: Int,
        buffers: Buffers,
    ): ByteBuffer {
        val binding = glGetActiveUniformBlocki(program, block, GL_UNIFORM_BLOCK_BINDING)
        val buffer = glGetIntegeri(GL_UNIFORM_BUFFER_BINDING, binding)
        val bytes = if (buffer == 0) ByteArray(0) else buffers.contents(buffer).bytes
        val start = glGetInteger64i(GL_UNIFORM_BUFFER_START, binding).coerceIn(0, bytes.size.toLong()).toInt()
        return ByteBuffer.wrap(bytes, start, bytes.size - start).slice().order(ByteOrder.nativeOrder())
    }

    private fun numbers(
        member: Member,
        block: ByteBuffer,
    ): FloatArray {
        val size = GlNumbers.components(member.type) ?: 0
        val rows = GlNumbers.rows(member.type)
        return FloatArray(size) { i ->
            val (column, row) = i / rows to i % rows
            val at = if (member.isRowMajor) row * member.stride + BYTES * column else column * member.stride + BYTES * row
            number(member, block, member.offset + at)
        }
    }

    private fun number(
        member: Member,
        block: ByteBuffer,
        at: Int,
    ): Float =
        when {
            at < 0 || at + BYTES > block.limit() -> 0f
            GlNumbers.isUnsigned(member.type) -> block.getInt(at).toUInt().toFloat()
            GlNumbers.isWhole(member.type) -> block.getInt(at).toFloat()
            else -> block.getFloat(at)
        }

    companion object {
        private const val BYTES = 4

        /** The blocks of the linked [program]; members that a capture cannot hold are noted on [tape]. */
        fun of(
            program: Int,
            sources: List<PlainUniforms>,
            tape: Tape,
        ): UniformBlocks {
            if (glGetProgrami(program, GL_ACTIVE_UNIFORM_BLOCKS) == 0) return UniformBlocks(program, emptyList())
            val members = (0 until glGetProgrami(program, GL_ACTIVE_UNIFORMS)).flatMap { members(program, it, sources, tape) }
            return UniformBlocks(program, members)
        }

        private fun members(
            program: Int,
            index: Int,
            sources: List<PlainUniforms>,
            tape: Tape,
        ): List<Member> {
            fun ask(what: Int) = glGetActiveUniformsi(program, index, what)
            val block = ask(GL_UNIFORM_BLOCK_INDEX)
            if (block < 0) return emptyList()
            val name = glGetActiveUniformName(program, index)
            val type = ask(GL_UNIFORM_TYPE)
            if (GlNumbers.components(type) == null || name.length > CaptureLimits.NAME || isOfArray(program, block)) {
                tape.event(EventKind.NOT_CAPTURED, "the uniform ${name.take(CaptureLimits.NAME)} in a block")
                return emptyList()
            }
            return Uniforms.elements(name, ask(GL_UNIFORM_SIZE)).flatMapIndexed { i, element ->
                val offset = ask(GL_UNIFORM_OFFSET) + i * ask(GL_UNIFORM_ARRAY_STRIDE)
                val names = sources.mapNotNull { it.name(element) }.distinct().ifEmpty { listOf(element) }
                names.map { Member(it, type, block, offset, ask(GL_UNIFORM_MATRIX_STRIDE), ask(GL_UNIFORM_IS_ROW_MAJOR) != 0) }
            }
        }

        private fun isOfArray(
            program: Int,
            block: Int,
        ) = glGetActiveUniformBlockName(program, block).endsWith("]")
    }
}

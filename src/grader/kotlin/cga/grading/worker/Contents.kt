package cga.grading.worker

import cga.grading.capture.DrawBounds
import cga.grading.capture.GlNumbers
import org.lwjgl.opengl.GL33C.*

/** Which objects have been written to since they were last read: a count for each that goes up with every write. */
internal class Writes {
    private val counts = HashMap<Int, Int>()
    private var all = 0

    /** The object [name] was written to. */
    fun note(name: Int) {
        counts[name] = (counts[name] ?: 0) + 1
    }

    /** Any object may have been written to. */
    fun noteAll() {
        all++
    }

    /** A number that differs from one asked for before if [name] was written to since. */
    fun count(name: Int): Long = all.toLong() shl 32 or (counts[name] ?: 0).toLong()
}

/** The contents of buffer objects, each read once after it was written to. */
internal class Buffers(private val tape: Tape) {
    val writes: Writes = Writes()
    private val stored = HashMap<Int, Stored>()
    private val largest = HashMap<List<Any>, Long?>()

    /** A buffer's contents; [number] is its number on the tape once it is asked for, null when it is not held there. */
    inner class Stored(
        val count: Long,
        val bytes: ByteArray,
    ) {
        val number: Int? by lazy { tape.buffer(bytes) }
    }

    /** The contents of the buffer object [name] now. */
    fun contents(name: Int): Stored {
        val count = writes.count(name)
        stored[name]?.takeIf { it.count == count }?.let { return it }
        return Stored(count, read(name)).also { stored[name] = it }
    }

    /** As [DrawBounds.largestIndex], remembered. */
    fun largestIndex(
        buffer: Stored,
        type: Int,
        first: Long,
        count: Int,
    ): Long? {
        val bytes = GlNumbers.indexBytes(type) ?: return null
        val key = listOf(buffer.number ?: return null, type, first, count)
        return largest.getOrPut(key) { DrawBounds.largestIndex(buffer.bytes, bytes, first, count) }
    }

    private fun read(name: Int): ByteArray {
        val before = glGetInteger(GL_COPY_READ_BUFFER)
        glBindBuffer(GL_COPY_READ_BUFFER, name)
        try {
            val bytes = ByteArray(glGetBufferParameteri(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE))
            if (bytes.isEmpty()) return bytes
            Native.bytes(bytes.size) {
                glGetBufferSubData(GL_COPY_READ_BUFFER, 0, it)
                it.get(bytes)
            }
            return bytes
        } finally {
            glBindBuffer(GL_COPY_READ_BUFFER, before)
        }
    }
}

package cga.grading.worker

import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil
import java.nio.ByteBuffer

/** Memory outside of the Java heap, for the length of a block. */
internal object Native {
    fun <T> bytes(
        size: Int,
        use: (ByteBuffer) -> T,
    ): T {
        val bytes = MemoryUtil.memAlloc(maxOf(size, 1))
        try {
            return use(bytes)
        } finally {
            MemoryUtil.memFree(bytes)
        }
    }
}

/** How OpenGL lays out what it is asked for. */
internal object Packing {
    private val LAYOUT = mapOf(GL_PACK_ALIGNMENT to 4, GL_PACK_ROW_LENGTH to 0, GL_PACK_SKIP_ROWS to 0, GL_PACK_SKIP_PIXELS to 0)

    /** Runs [block] with rows packed tightly into the memory given, and puts back whatever the submission had set. */
    fun <T> plain(block: () -> T): T {
        val buffer = glGetInteger(GL_PIXEL_PACK_BUFFER_BINDING)
        val before = LAYOUT.keys.associateWith { glGetInteger(it) }
        if (buffer != 0) glBindBuffer(GL_PIXEL_PACK_BUFFER, 0)
        LAYOUT.forEach { (name, value) -> glPixelStorei(name, value) }
        try {
            return block()
        } finally {
            before.forEach { (name, value) -> glPixelStorei(name, value) }
            if (buffer != 0) glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer)
        }
    }
}

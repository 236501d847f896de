package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedAttribute
import cga.grading.capture.CapturedDraw
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** The vertices that a captured draw reads. Whatever lies outside of its buffers is left out: a capture is not to be believed. */
internal class DrawVertices(
    private val capture: Capture,
    private val draw: CapturedDraw,
) {
    /** Numbers of the vertices in drawing order, at most [MAX_VERTICES]. */
    val order: IntArray = if (draw.indices == null) consecutive() else indexed(draw.indices)

    /** The same, each once. */
    val distinct: IntArray by lazy { order.distinct().toIntArray() }

    /** Four numbers of [vertex] at [location] as the shader sees them, or null where nothing is bound or readable. */
    fun read(
        location: Int,
        vertex: Int,
    ): DoubleArray? {
        val attribute = draw.attributes.find { it.location == location } ?: return null
        val bytes = buffer(attribute.buffer) ?: return null
        val width = width(attribute.type) ?: return null
        val stride = if (attribute.stride != 0) attribute.stride else attribute.size * width
        val start = attribute.offset + vertex.toLong() * stride
        if (start < 0 || start + attribute.size * width > bytes.capacity()) return null
        val result = doubleArrayOf(0.0, 0.0, 0.0, 1.0)
        for (i in 0 until attribute.size.coerceIn(1, 4)) result[i] = number(bytes, attribute, start.toInt() + i * width)
        return result
    }

    private fun number(
        bytes: ByteBuffer,
        attribute: CapturedAttribute,
        at: Int,
    ): Double {
        val (value, largest) =
            when (attribute.type) {
                GL_FLOAT -> return bytes.getFloat(at).toDouble()
                GL_DOUBLE -> return bytes.getDouble(at)
                GL_BYTE -> bytes.get(at).toDouble() to 127.0
                GL_UNSIGNED_BYTE -> (bytes.get(at).toInt() and 0xFF).toDouble() to 255.0
                GL_SHORT -> bytes.getShort(at).toDouble() to 32767.0
                GL_UNSIGNED_SHORT -> (bytes.getShort(at).toInt() and 0xFFFF).toDouble() to 65535.0
                else -> bytes.getInt(at).toDouble() to 2147483647.0
            }
        return if (attribute.normalized) maxOf(value / largest, -1.0) else value
    }

    private fun width(type: Int): Int? =
        when (type) {
            GL_FLOAT, GL_INT, GL_UNSIGNED_INT -> 4
            GL_DOUBLE -> 8
            GL_BYTE, GL_UNSIGNED_BYTE -> 1
            GL_SHORT, GL_UNSIGNED_SHORT -> 2
            else -> null
        }

    private fun consecutive(): IntArray {
        val first = draw.first.coerceIn(0, Int.MAX_VALUE.toLong() / 2).toInt()
        return IntArray(draw.count.coerceIn(0, MAX_VERTICES)) { first + it }
    }

    private fun indexed(number: Int): IntArray {
        val bytes = buffer(number) ?: return IntArray(0)
        val width = width(draw.indexType) ?: return IntArray(0)
        val start = draw.first.coerceIn(0, bytes.capacity().toLong()).toInt()
        val count = minOf(draw.count, MAX_VERTICES, (bytes.capacity() - start) / width).coerceAtLeast(0)
        return IntArray(count) { i ->
            val at = start + i * width
            draw.baseVertex +
                when (width) {
                    1 -> bytes.get(at).toInt() and 0xFF
                    2 -> bytes.getShort(at).toInt() and 0xFFFF
                    else -> bytes.getInt(at)
                }
        }
    }

    private fun buffer(number: Int): ByteBuffer? = capture.buffers
        .getOrNull(
            number,
        )?.let { ByteBuffer.wrap(it).order(ByteOrder.nativeOrder()) }

    private companion object {
        const val MAX_VERTICES = 3_000_000
    }
}

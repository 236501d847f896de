package cga.grading.capture

import java.io.EOFException
import java.io.InputStream
import java.nio.ByteBuffer
import java.nio.charset.CharacterCodingException
import java.util.zip.ZipException

/** Reads numbers, names and bytes from a stream that is not trusted: never more than [left] bytes in all, never more memory than has arrived. */
internal class LimitedInput(
    private val input: InputStream,
    private var left: Long,
) {
    private var elementsLeft = CaptureLimits.ELEMENTS
    private val word = ByteArray(Long.SIZE_BYTES)

    fun byte(): Int = fill(1).get().toInt() and 0xFF

    fun int(): Int = fill(Int.SIZE_BYTES).int

    fun long(): Long = fill(Long.SIZE_BYTES).long

    fun float(): Float = Float.fromBits(int())

    fun double(): Double = Double.fromBits(long())

    fun boolean(): Boolean =
        when (val value = byte()) {
            0 -> false
            1 -> true
            else -> throw BadCapture("$value stands where yes or no belongs")
        }

    /** A number within [range]; [what] names it in the error. */
    fun int(
        what: String,
        range: IntRange,
    ): Int {
        val value = int()
        if (value !in range) throw BadCapture("$what is $value, allowed is $range")
        return value
    }

    /** A list of at most [limit] elements. */
    fun <T> list(
        what: String,
        limit: Int,
        element: () -> T,
    ): List<T> {
        val size = int("the number of $what", 0..limit)
        elementsLeft -= size
        if (elementsLeft < 0) throw BadCapture("the capture has more parts than allowed")
        val list = ArrayList<T>(minOf(size, FIRST_ELEMENTS))
        repeat(size) { list += element() }
        return list
    }

    /** A map of at most [limit] entries, no key twice. */
    fun <K, V> map(
        what: String,
        limit: Int,
        entry: () -> Pair<K, V>,
    ): Map<K, V> {
        val entries = list(what, limit, entry)
        val map = entries.toMap(LinkedHashMap())
        if (map.size != entries.size) throw BadCapture("two of the $what have one name")
        return map
    }

    /** Text of at most [limit] bytes. */
    fun text(
        what: String,
        limit: Int,
    ): String =
        try {
            Charsets.UTF_8
                .newDecoder()
                .decode(ByteBuffer.wrap(bytes(what, limit)))
                .toString()
        } catch (_: CharacterCodingException) {
            throw BadCapture("$what is not text")
        }

    /** At most [limit] bytes. */
    fun bytes(
        what: String,
        limit: Int,
    ): ByteArray {
        val size = int("the size of $what", 0..limit)
        take(size)
        // A claimed size is believed as far as bytes arrive.
        var bytes = ByteArray(minOf(size, FIRST_BYTES))
        var filled = 0
        while (filled < size) {
            if (filled == bytes.size) bytes = bytes.copyOf(minOf(size.toLong(), 4L * filled).toInt())
            fill(bytes, filled, bytes.size - filled)
            filled = bytes.size
        }
        return bytes
    }

    /** Throws when anything is left. */
    fun expectEnd() {
        if (guarded { input.read() } >= 0) throw BadCapture("something follows the end of the capture")
    }

    private fun fill(size: Int): ByteBuffer {
        take(size)
        fill(word, 0, size)
        return ByteBuffer.wrap(word, 0, size)
    }

    private fun fill(
        bytes: ByteArray,
        offset: Int,
        size: Int,
    ) {
        if (guarded { input.readNBytes(bytes, offset, size) } < size) throw BadCapture("the capture ends too early")
    }

    private fun take(size: Int) {
        left -= size
        if (left < 0) throw BadCapture("the capture is larger than allowed")
    }

    private inline fun guarded(read: () -> Int): Int =
        try {
            read()
        } catch (_: EOFException) {
            throw BadCapture("the capture ends too early")
        } catch (e: ZipException) {
            throw BadCapture("the capture is damaged (${e.message})")
        }

    private companion object {
        const val FIRST_ELEMENTS = 64
        const val FIRST_BYTES = 1 shl 16
    }
}

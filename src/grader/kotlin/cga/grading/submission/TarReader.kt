package cga.grading.submission

import java.io.FilterInputStream
import java.io.IOException
import java.io.InputStream

/** Reads a tar archive (POSIX ustar with pax headers, GNU long names) from [stream]. */
internal class TarReader(
    private val stream: InputStream,
) {
    private var longName: String? = null

    /** Gives every entry to [take]. Throws [IOException] where the archive is broken. */
    fun readAll(take: (name: String, kind: EntryKind, content: InputStream) -> Unit) {
        while (true) {
            val header = stream.readNBytes(BLOCK)
            if (header.size < BLOCK || header.all { it.toInt() == 0 }) return
            checkSum(header)
            val size = number(header, 124, 12)
            val content = Content(size)
            when (val type = header[156].toInt().toChar()) {
                'L' -> longName = text(content.readNBytes(LONGEST_NAME), 0, LONGEST_NAME)
                'x' -> paxPath(content.readNBytes(LONGEST_HEADER))?.let { longName = it }
                'g', 'K' -> Unit
                else -> {
                    val name = longName ?: name(header)
                    longName = null
                    take(name, kind(type, name), content)
                }
            }
            content.skipRest()
            stream.skipNBytes((BLOCK - size % BLOCK) % BLOCK)
        }
    }

    private fun kind(type: Char, name: String) =
        when (type) {
            '0', '\u0000', '7' -> if (name.endsWith('/')) EntryKind.FOLDER else EntryKind.FILE
            '5' -> EntryKind.FOLDER
            '1', '2' -> EntryKind.LINK
            else -> EntryKind.DEVICE
        }

    private fun name(header: ByteArray): String {
        val isUstar = text(header, 257, 5) == "ustar"
        // GNU's own variant has dates where POSIX has the prefix.
        val prefix = if (isUstar && header[262].toInt() == 0) text(header, 345, 155) else ""
        return (if (prefix.isEmpty()) "" else "$prefix/") + text(header, 0, 100)
    }

    /** The path in a pax header: records of `length key=value\n`. */
    private fun paxPath(bytes: ByteArray): String? =
        bytes.decodeToString().lines().map { it.substringAfter(' ') }.firstOrNull { it.startsWith("path=") }?.removePrefix("path=")

    private fun text(bytes: ByteArray, from: Int, length: Int): String {
        val to = minOf(from + length, bytes.size)
        val end = (from until to).firstOrNull { bytes[it].toInt() == 0 } ?: to
        return bytes.decodeToString(from, end)
    }

    private fun number(header: ByteArray, from: Int, length: Int): Long {
        if (header[from] < 0) throw IOException("an entry of more than 8 GiB")
        val digits = text(header, from, length).trim()
        // A sign is no digit: what has less than no content is broken.
        if (digits.any { it !in '0'..'7' }) throw IOException("a broken header")
        return if (digits.isEmpty()) 0 else digits.toLong(8)
    }

    private fun checkSum(header: ByteArray) {
        val sum = header.indices.sumOf { if (it in CHECKSUM) ' '.code else header[it].toInt() and 0xff }
        if (number(header, CHECKSUM.first, 8) != sum.toLong()) throw IOException("a broken header")
    }

    /** The [left] bytes that belong to one entry. */
    private inner class Content(private var left: Long) : FilterInputStream(stream) {
        override fun read(): Int = ByteArray(1).let { if (read(it, 0, 1) < 0) -1 else it[0].toInt() and 0xff }

        override fun read(buffer: ByteArray, offset: Int, length: Int): Int {
            if (left == 0L) return if (length == 0) 0 else -1
            val count = super.read(buffer, offset, minOf(length.toLong(), left).toInt())
            if (count < 0) throw IOException("the archive ends within a file")
            left -= count
            return count
        }

        override fun close() = Unit

        fun skipRest() {
            val buffer = ByteArray(BLOCK)
            while (left > 0) read(buffer, 0, BLOCK)
        }
    }

    private companion object {
        const val BLOCK = 512
        const val LONGEST_NAME = 4096
        const val LONGEST_HEADER = 65536
        val CHECKSUM = 148 until 156
    }
}

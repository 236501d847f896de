package cga.imaging.file

import cga.framework.InputError
import cga.framework.image.FloatImage
import cga.imaging.FloatPicture
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Reads OpenEXR: one picture of scan lines, uncompressed, ZIPS or ZIP, 16-bit or 32-bit floats.
 *
 * The C library that writes such files is not trusted to read them: a memory error in it would end the whole program.
 */
internal object ExrReader {
    /** The picture in [file], whose values are finite. Throws [InputError] with what is wrong. */
    fun read(file: ByteArray): FloatPicture {
        val header = ExrHeader(file)
        val rowBytes = header.width * header.channels.sumOf { it.bytes }
        checkStored(rowBytes.toLong() * header.height, file.size - header.end)
        val rgba = FloatArray(4 * header.width * header.height)
        val hasAlpha = header.channels.any { it.name == "A" }
        if (!hasAlpha) for (i in 3 until rgba.size step 4) rgba[i] = 1f
        val bytes = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN)
        val blockRows = header.compression.rowsPerBlock
        for (row in 0 until header.height step blockRows) {
            val rows = minOf(blockRows, header.height - row)
            val block = block(header, bytes, row, rowBytes * rows)
            for (i in 0 until rows) expand(header, block, i * rowBytes, rgba, 4 * header.width * (row + i))
        }
        return FloatPicture(FloatImage(header.width, header.height, rgba), hasAlpha)
    }

    /** The [size] bytes of the block that begins with [row], which counts from 0: its place is in the table behind the header. */
    private fun block(
        header: ExrHeader,
        bytes: ByteBuffer,
        row: Int,
        size: Int,
    ): ByteBuffer {
        val entry = header.end + 8L * (row / header.compression.rowsPerBlock)
        if (entry + 8 > bytes.limit()) throw InputError("it is cut off after ${bytes.limit()} bytes: save it again.")
        val place = bytes.getLong(entry.toInt())
        // An unfinished file has zeros in its table.
        if (place < header.end || place > bytes.limit() - 8) throw InputError("row $row is missing: save it again.")
        val start = place.toInt()
        val stored = bytes.getInt(start + 4)
        if (stored < 0 || stored > bytes.limit() - start - 8) throw InputError("it is cut off in row $row: save it again.")
        if (bytes.getInt(start) !=
            header.top + row
        ) {
            throw InputError("it is damaged (another row in the place of row $row): save it again.")
        }
        if (stored > size || (stored < size && header.compression == ExrCompression.NONE)) {
            throw InputError("it is damaged ($stored bytes for row $row, not $size): save it again.")
        }
        // What would not become smaller is stored as it is.
        val content = if (stored ==
            size
        ) {
            bytes.array().copyOfRange(start + 8, start + 8 + size)
        } else {
            unzip(bytes.array(), start + 8, stored, size)
        }
        return ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN)
    }

    /** Undoes ZIP: zlib, then differences from byte to byte, then the even bytes before the odd ones. */
    private fun unzip(
        file: ByteArray,
        start: Int,
        stored: Int,
        size: Int,
    ): ByteArray {
        val halves = ByteArray(size)
        InflatedStream(file, listOf(InflatedStream.Piece(start, stored))).use {
            it.read(halves, size)
            it.finish()
        }
        for (i in 1 until size) halves[i] = (halves[i - 1] + halves[i] - 128).toByte()
        val odd = (size + 1) / 2
        return ByteArray(size) { i -> if (i % 2 == 0) halves[i / 2] else halves[odd + i / 2] }
    }

    /** A row: all values of the first channel, then all of the next. */
    private fun expand(
        header: ExrHeader,
        block: ByteBuffer,
        start: Int,
        rgba: FloatArray,
        target: Int,
    ) {
        var from = start
        for (channel in header.channels) {
            for (x in 0 until header.width) {
                val at = from + x * channel.bytes
                val value = if (channel.isHalf) halfToFloat(block.getShort(at).toInt()) else block.getFloat(at)
                for (c in channel.targets) rgba[target + 4 * x + c] = value
            }
            from += header.width * channel.bytes
        }
    }

    /** The value of a 16-bit float: sign, 5 bits of exponent, 10 bits of fraction (IEEE 754-2008, binary16). */
    internal fun halfToFloat(bits: Int): Float {
        val sign = bits and 0x8000 shl 16
        val exponent = bits shr 10 and 0x1F
        val fraction = bits and 0x3FF
        return when (exponent) {
            // Too small for an exponent of their own: multiples of 2⁻²⁴.
            0 -> (if (sign == 0) 1f else -1f) * (fraction * SMALLEST_HALF)
            0x1F -> Float.fromBits(sign or 0x7F800000 or (fraction shl 13))
            else -> Float.fromBits(sign or (exponent + 127 - 15 shl 23) or (fraction shl 13))
        }
    }

    private const val SMALLEST_HALF = 1f / (1 shl 24)
}

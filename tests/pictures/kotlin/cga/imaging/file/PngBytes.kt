package cga.imaging.file

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.util.zip.CRC32
import java.util.zip.Deflater

/** PNG files by hand, right and wrong ones. */
internal object PngBytes {
    /** A file of the given [chunks]: the signature and the chunks, one after the other. */
    fun of(vararg chunks: ByteArray): ByteArray = chunks.fold(PngChunks.SIGNATURE, ByteArray::plus)

    /** A whole file; [rows] are its pixels with the byte of the filter before each row. */
    fun picture(
        header: ByteArray,
        rows: ByteArray,
        vararg between: ByteArray,
    ): ByteArray = of(header, *between, chunk("IDAT", deflated(rows)), END)

    fun header(
        width: Int,
        height: Int,
        colour: Int = 2,
        depth: Int = 8,
        compression: Int = 0,
        filter: Int = 0,
        interlace: Int = 0,
    ): ByteArray {
        val fields = listOf(depth, colour, compression, filter, interlace).map { it.toByte() }.toByteArray()
        return chunk("IHDR", ByteBuffer.allocate(8).putInt(width).putInt(height).array() + fields)
    }

    fun chunk(
        type: String,
        content: ByteArray = ByteArray(0),
    ): ByteArray {
        val body = type.toByteArray(Charsets.ISO_8859_1) + content
        val sum = CRC32().apply { update(body) }.value.toInt()
        return ByteBuffer
            .allocate(8 + body.size)
            .putInt(content.size)
            .put(body)
            .putInt(sum)
            .array()
    }

    val END: ByteArray = chunk("IEND")
}

/** [bytes] as a zlib stream. */
internal fun deflated(bytes: ByteArray): ByteArray {
    val deflater = Deflater()
    deflater.setInput(bytes)
    deflater.finish()
    val out = ByteArrayOutputStream()
    val buffer = ByteArray(4096)
    while (!deflater.finished()) out.write(buffer, 0, deflater.deflate(buffer))
    deflater.end()
    return out.toByteArray()
}

internal fun bytes(vararg values: Int): ByteArray = ByteArray(values.size) { values[it].toByte() }

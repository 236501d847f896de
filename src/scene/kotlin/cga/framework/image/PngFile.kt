package cga.framework.image

import cga.framework.AtomicFile
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.Adler32
import java.util.zip.CRC32

/**
 * Writes pictures as 8-bit RGB PNG; alpha is dropped, since a framebuffer's picture is opaque.
 *
 * Made for speed: the rows are packed by all processors, a [PngStrip] each, and joined to the one stream that PNG wants. A file is the
 * same bytes however many processors there were.
 */
public object PngFile {
    private val SIGNATURE = byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10)
    private val ZLIB_HEADER = byteArrayOf(0x78, 0x01)

    // Eight bits a channel; red, green, blue; deflate, filters by row, not interlaced.
    private val FORMAT = byteArrayOf(8, 2, 0, 0, 0)

    /** Strips packed at a time, which bounds the memory that it takes. */
    private const val BATCH = 16

    /** Writes [image] to [target], whole or not at all. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(
        image: ImageData,
        target: Path,
    ): Unit = AtomicFile.write(target) { temporary -> Files.newOutputStream(temporary).use { encode(image, it) } }

    private fun encode(
        image: ImageData,
        file: OutputStream,
    ) {
        start(file, image.width, image.height)
        pixels(image) { chunk(file, "IDAT", it) }
        chunk(file, "IEND", emptyList())
    }

    /** Writes what every PNG file of this size begins with. */
    internal fun start(
        file: OutputStream,
        width: Int,
        height: Int,
    ) {
        file.write(SIGNATURE)
        chunk(file, "IHDR", listOf(bytes(width), bytes(height), FORMAT))
    }

    /** Packs the pixels of [image] and hands the stream to [emit] piece by piece: the contents of its chunks. */
    internal fun pixels(
        image: ImageData,
        emit: (List<ByteArray>) -> Unit,
    ) {
        val checksum = Adler32()
        val last = (image.height - 1) / PngStrip.ROWS
        for (batch in (0..last).chunked(BATCH)) {
            val strips = batch.parallelStream().map { PngStrip(image, it * PngStrip.ROWS) }.toList()
            strips.forEach { checksum.update(it.filtered) }
            val packed = strips.map { it.packed }
            val header = if (batch.first() == 0) listOf(ZLIB_HEADER) else emptyList()
            val trailer = if (batch.last() == last) listOf(bytes(checksum.value.toInt())) else emptyList()
            emit(header + packed + trailer)
        }
    }

    /** Writes one chunk. */
    internal fun chunk(
        file: OutputStream,
        type: String,
        content: List<ByteArray>,
    ) {
        val checksum = CRC32()
        val name = type.toByteArray()
        file.write(bytes(content.sumOf { it.size }))
        for (part in listOf(name) + content) {
            file.write(part)
            checksum.update(part)
        }
        file.write(bytes(checksum.value.toInt()))
    }

    /** Most significant byte first. */
    internal fun bytes(number: Int) = ByteArray(Int.SIZE_BYTES) { (number shr (24 - 8 * it)).toByte() }
}

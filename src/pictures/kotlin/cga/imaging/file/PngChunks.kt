package cga.imaging.file

import cga.framework.InputError
import java.nio.ByteBuffer
import java.util.zip.CRC32

/**
 * The chunks of a PNG file that make its pixels. Throws [InputError] where the file is not whole: the order of chunks, every length, every
 * checksum, and the end are checked. Chunks that only tell how to show the picture (gamma, colour profile, text, …) are left out.
 */
internal class PngChunks(
    private val file: ByteArray,
) {
    val header: PngHeader
    var palette: ByteArray? = null
        private set

    /** The chunk tRNS: alpha of palette entries, or the one colour that is transparent. */
    var transparency: ByteArray? = null
        private set

    /** Where the compressed pixels are. */
    val data = mutableListOf<InflatedStream.Piece>()

    init {
        var at = SIGNATURE.size
        val first = Chunk(at)
        if (first.type != "IHDR") throw InputError("its first chunk is ${first.name}, not IHDR: save it again.")
        header = PngHeader(first.content())
        var last = first
        while (last.type != "IEND") {
            at = last.end
            val chunk = Chunk(at)
            take(chunk, last)
            last = chunk
        }
        if (last.length != 0) throw InputError("its chunk IEND is not empty: save it again.")
        if (last.end != file.size) throw InputError("${file.size - last.end} bytes follow its end: save it again.")
        if (data.isEmpty()) throw InputError("it has no pixels (no chunk IDAT): save it again.")
    }

    private fun take(
        chunk: Chunk,
        previous: Chunk,
    ) {
        when (chunk.type) {
            "PLTE" -> palette = chunk.onlyOnce(palette)
            "tRNS" -> transparency = chunk.onlyOnce(transparency)
            "IDAT" -> {
                if (data.isNotEmpty() &&
                    previous.type != "IDAT"
                ) {
                    throw InputError("its pixels (chunks IDAT) are torn apart: save it again.")
                }
                data += InflatedStream.Piece(chunk.start, chunk.length)
            }
            "IEND" -> {}
            "acTL", "fcTL", "fdAT" -> throw InputError("it is animated: save one picture of it as PNG.")
            // The case of the first letter says whether a reader may do without the chunk.
            else -> if (chunk.type.first() in 'A'..'Z') throw InputError("its chunk ${chunk.name} is not known: save it again.")
        }
    }

    private fun Chunk.onlyOnce(earlier: ByteArray?): ByteArray {
        if (earlier != null) throw InputError("it has the chunk $name twice: save it again.")
        if (data.isNotEmpty()) throw InputError("its chunk $name comes after the pixels: save it again.")
        return content()
    }

    /** The chunk whose length field is at [at]: length, type, content, checksum of type and content. */
    private inner class Chunk(
        at: Int,
    ) {
        val length: Int
        val type: String
        val start = at + 8
        val end: Int

        /** The type as it may be shown: it comes from the file. */
        val name: String get() = if (type.all { it in 'A'..'Z' || it in 'a'..'z' }) type else "of an unknown kind"

        init {
            // Length, type and checksum take 12 bytes.
            val room = file.size - at - 12
            length = if (room >= 0) ByteBuffer.wrap(file).getInt(at) else 0
            if (room < 0 || length > room) throw InputError("it is cut off after ${file.size} bytes: save it again.")
            if (length < 0) throw InputError("it is damaged (the length of a chunk at byte $at is negative): save it again.")
            type = String(file, at + 4, 4, Charsets.ISO_8859_1)
            end = start + length + 4
            val sum = CRC32()
            sum.update(file, at + 4, 4 + length)
            if (sum.value.toInt() != ByteBuffer.wrap(file).getInt(end - 4)) {
                throw InputError("it is damaged (the checksum of the chunk at byte $at is wrong): save it again.")
            }
        }

        fun content(): ByteArray = file.copyOfRange(start, start + length)
    }

    companion object {
        val SIGNATURE = byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10)
    }
}

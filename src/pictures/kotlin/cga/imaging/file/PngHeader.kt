package cga.imaging.file

import cga.framework.InputError
import java.nio.ByteBuffer

/** What the chunk IHDR says. Throws [InputError] for a picture that is not read: broken, or with 16 bits a channel. */
internal class PngHeader(
    content: ByteArray,
) {
    /** Unsigned, not yet checked against a limit. */
    val width: Long
    val height: Long

    /** Bits of a channel, or of a palette's index: 1, 2, 4 or 8. */
    val depth: Int
    val colour: PngColour
    val interlaced: Boolean

    init {
        if (content.size != 13) throw InputError("its header has ${content.size} bytes, not 13: save it again.")
        val fields = ByteBuffer.wrap(content)
        width = Integer.toUnsignedLong(fields.getInt())
        height = Integer.toUnsignedLong(fields.getInt())
        depth = fields.get().toInt()
        val code = fields.get().toInt()
        val known = PngColour.entries.find { it.code == code }
        if (depth == 16) throw InputError("it has 16 bits a channel, and pictures are compared at 8: save it with 8, or as OpenEXR.")
        if (known == null ||
            depth !in known.depths
        ) {
            throw InputError("its header is wrong (colour type $code, $depth bits): save it again.")
        }
        colour = known
        val (compression, filter, interlace) = List(3) { fields.get().toInt() }
        if (compression != 0 || filter != 0 || interlace !in 0..1) {
            throw InputError("its header is wrong (compression $compression, filter $filter, interlace $interlace): save it again.")
        }
        interlaced = interlace == 1
    }

    val bitsPerPixel: Int get() = depth * colour.channels

    /** The rectangles of pixels that are stored one after the other: one, or the seven of Adam7, each finer than the one before. */
    val passes: List<PngPass>
        get() = if (interlaced) ADAM7.map { PngPass(this, it[0], it[1], it[2], it[3]) } else listOf(PngPass(this, 0, 0, 1, 1))

    private companion object {
        // Left, top, step to the right, step down: PNG specification, 8.2.
        val ADAM7 =
            listOf(
                intArrayOf(0, 0, 8, 8),
                intArrayOf(4, 0, 8, 8),
                intArrayOf(0, 4, 4, 8),
                intArrayOf(2, 0, 4, 4),
                intArrayOf(0, 2, 2, 4),
                intArrayOf(1, 0, 2, 2),
                intArrayOf(0, 1, 1, 2),
            )
    }
}

/** Every [right]-th pixel of every [down]-th row, from [left], [top]. */
internal class PngPass(
    header: PngHeader,
    val left: Int,
    val top: Int,
    val right: Int,
    val down: Int,
) {
    val width: Long = (header.width - left + right - 1) / right
    val height: Long = (header.height - top + down - 1) / down

    /** Bytes of a row, without the byte that names its filter. */
    val rowBytes: Long = (width * header.bitsPerPixel + 7) / 8

    /** Bytes of the pass before compression; a pass without pixels has none. */
    val bytes: Long get() = if (width == 0L || height == 0L) 0 else height * (rowBytes + 1)
}

/** PNG's kinds of colour. */
internal enum class PngColour(
    val code: Int,
    val channels: Int,
    val depths: Set<Int>,
) {
    GREY(0, 1, setOf(1, 2, 4, 8)),
    RGB(2, 3, setOf(8)),
    PALETTE(3, 1, setOf(1, 2, 4, 8)),
    GREY_ALPHA(4, 2, setOf(8)),
    RGBA(6, 4, setOf(8)),
}

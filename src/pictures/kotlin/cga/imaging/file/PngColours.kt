package cga.imaging.file

import cga.framework.InputError

/** Turns a row of stored samples into RGBA, without loss. */
internal class PngColours(
    private val header: PngHeader,
    palette: ByteArray?,
    private val transparency: ByteArray?,
) {
    val hasAlpha: Boolean = header.colour == PngColour.GREY_ALPHA || header.colour == PngColour.RGBA || transparency != null

    /** RGBA of each stored value; for what has one sample a pixel and at most 8 bits. */
    private val table: ByteArray =
        when (header.colour) {
            PngColour.PALETTE -> paletteTable(palette ?: throw InputError("it has no palette (chunk PLTE): save it again."))
            PngColour.GREY -> greyTable()
            else -> ByteArray(0)
        }

    private val transparentRgb: Int = if (header.colour == PngColour.RGB && transparency != null) transparentColour(transparency, 3) else -1

    init {
        if (transparency != null && (header.colour == PngColour.GREY_ALPHA || header.colour == PngColour.RGBA)) {
            throw InputError("it has alpha twice (chunk tRNS): save it again.")
        }
    }

    private fun paletteTable(palette: ByteArray): ByteArray {
        val count = palette.size / 3
        if (palette.size % 3 != 0 || count !in 1..(1 shl header.depth)) {
            throw InputError("its palette of ${palette.size} bytes does not fit ${header.depth} bits: save it again.")
        }
        if ((transparency?.size ?: 0) > count) throw InputError("it has more transparencies than colours in its palette: save it again.")
        return ByteArray(4 * count) { i ->
            if (i % 4 < 3) palette[i / 4 * 3 + i % 4] else transparency?.getOrNull(i / 4) ?: OPAQUE
        }
    }

    private fun greyTable(): ByteArray {
        val largest = (1 shl header.depth) - 1
        val transparent = transparency?.let { transparentColour(it, 1) } ?: -1
        return ByteArray(4 * (largest + 1)) { i ->
            // 255 is a multiple of 1, 3, 15 and 255: nothing is rounded.
            if (i % 4 < 3) {
                (i / 4 * (255 / largest)).toByte()
            } else if (i / 4 == transparent) {
                0
            } else {
                OPAQUE
            }
        }
    }

    /** The one transparent colour as a number of 8 bits a channel; it is stored with 16, of which only the pictures' own count. */
    private fun transparentColour(
        content: ByteArray,
        channels: Int,
    ): Int {
        if (content.size != 2 * channels) throw InputError("its transparent colour has ${content.size} bytes: save it again.")
        return (0 until channels).fold(0) { colour, c -> colour shl 8 or (content[2 * c + 1].toInt() and 0xFF) }
    }

    /** Writes [count] pixels of [row] to [rgba], the first at [start], each [step] bytes after the one before. */
    fun expand(
        row: ByteArray,
        count: Int,
        rgba: ByteArray,
        start: Int,
        step: Int,
    ) {
        var to = start
        when (header.colour) {
            PngColour.PALETTE, PngColour.GREY -> expandIndices(row, count, rgba, start, step)
            PngColour.GREY_ALPHA ->
                for (i in 0 until count) {
                    rgba.fill(row[2 * i], to, to + 3)
                    rgba[to + 3] = row[2 * i + 1]
                    to += step
                }
            PngColour.RGB ->
                for (i in 0 until count) {
                    for (c in 0 until 3) rgba[to + c] = row[3 * i + c]
                    rgba[to + 3] = if (transparentRgb >= 0 && rgb(row, 3 * i) == transparentRgb) 0 else OPAQUE
                    to += step
                }
            PngColour.RGBA ->
                for (i in 0 until count) {
                    for (c in 0 until 4) rgba[to + c] = row[4 * i + c]
                    to += step
                }
        }
    }

    private fun expandIndices(
        row: ByteArray,
        count: Int,
        rgba: ByteArray,
        start: Int,
        step: Int,
    ) {
        val depth = header.depth
        val mask = (1 shl depth) - 1
        for (i in 0 until count) {
            val bit = i * depth
            val index = row[bit / 8].toInt() shr (8 - depth - bit % 8) and mask
            if (4 * index >= table.size) {
                throw InputError("its palette has ${table.size / 4} colours, and a pixel asks for number $index: save it again.")
            }
            table.copyInto(rgba, start + i * step, 4 * index, 4 * index + 4)
        }
    }

    private fun rgb(
        row: ByteArray,
        at: Int,
    ): Int = (0 until 3).fold(0) { colour, c -> colour shl 8 or (row[at + c].toInt() and 0xFF) }

    private companion object {
        const val OPAQUE: Byte = -1
    }
}

package cga.imaging.file

import cga.framework.InputError
import cga.framework.image.ImageData
import cga.imaging.BytePicture
import kotlin.math.abs

/**
 * Reads PNG as the specification (ISO/IEC 15948) has it, 8 bits a channel or fewer.
 *
 * The JDK's own reader is not used: it takes files without an end, with data left over, or with indices outside of the palette for good
 * pictures, and takes the memory that a header asks for before it looks for the pixels.
 */
internal object PngReader {
    /** The picture in [file]; grey and palettes become the colours that they mean. Throws [InputError] with what is wrong. */
    fun read(file: ByteArray): BytePicture {
        val chunks = PngChunks(file)
        val header = chunks.header
        checkSize(header.width, header.height)
        checkStored(header.passes.sumOf { it.bytes }, chunks.data.sumOf { it.length })
        val colours = PngColours(header, chunks.palette, chunks.transparency)
        val rgba = ByteArray(4 * header.width.toInt() * header.height.toInt())
        InflatedStream(file, chunks.data).use { stream ->
            for (pass in header.passes) if (pass.bytes > 0) read(pass, header, colours, stream, rgba)
            stream.finish()
        }
        return BytePicture(ImageData(header.width.toInt(), header.height.toInt(), rgba), colours.hasAlpha)
    }

    private fun read(
        pass: PngPass,
        header: PngHeader,
        colours: PngColours,
        stream: InflatedStream,
        rgba: ByteArray,
    ) {
        val size = pass.rowBytes.toInt()
        val pixelBytes = maxOf(1, header.bitsPerPixel / 8)
        val filter = ByteArray(1)
        var above = ByteArray(size)
        var row = ByteArray(size)
        for (y in 0 until pass.height.toInt()) {
            stream.read(filter, 1)
            stream.read(row, size)
            unfilter(filter[0].toInt(), row, above, pixelBytes)
            val target = 4 * ((pass.top + y * pass.down) * header.width.toInt() + pass.left)
            colours.expand(row, pass.width.toInt(), rgba, target, 4 * pass.right)
            above = row.also { row = above }
        }
    }

    /** Adds to each byte of [row] what the filter foretells from the bytes to the left and [above]: PNG specification, 9. */
    private fun unfilter(
        filter: Int,
        row: ByteArray,
        above: ByteArray,
        step: Int,
    ) {
        when (filter) {
            0 -> {}
            1 -> for (i in step until row.size) row[i] = (row[i] + row[i - step]).toByte()
            2 -> for (i in row.indices) row[i] = (row[i] + above[i]).toByte()
            3 -> {
                for (i in 0 until minOf(step, row.size)) row[i] = (row[i] + above.at(i) / 2).toByte()
                for (i in step until row.size) row[i] = (row[i] + (row.at(i - step) + above.at(i)) / 2).toByte()
            }
            4 -> {
                for (i in 0 until minOf(step, row.size)) row[i] = (row[i] + above[i]).toByte()
                for (i in step until row.size) row[i] = (row[i] + paeth(row.at(i - step), above.at(i), above.at(i - step))).toByte()
            }
            else -> throw InputError("its data are damaged (a row has the unknown filter ${filter and 0xFF}): save it again.")
        }
    }

    private fun paeth(
        left: Int,
        above: Int,
        corner: Int,
    ): Int {
        val toLeft = abs(above - corner)
        val toAbove = abs(left - corner)
        val toCorner = abs(left + above - 2 * corner)
        return when {
            toLeft <= toAbove && toLeft <= toCorner -> left
            toAbove <= toCorner -> above
            else -> corner
        }
    }

    private fun ByteArray.at(index: Int): Int = this[index].toInt() and 0xFF
}

package cga.imaging.report

import cga.framework.image.ImageData
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.util.zip.CRC32
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream

/**
 * Encodes pictures as 8-bit PNG, as small as deflate gets them, for pages that carry their pictures; alpha is dropped.
 *
 * A picture of at most 256 colours gets a palette. Renders of the scene come out at 55 to 75 % of what
 * [cga.framework.image.PngFile] writes.
 */
public object SmallPng {
    private val SIGNATURE = byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10)
    private const val PALETTE_SIZE = 256
    private const val COLOR_TYPE_RGB = 2
    private const val COLOR_TYPE_PALETTE = 3
    private const val BUFFER_SIZE = 1 shl 16

    // Of PNG's filters those that win on our renders: the difference from the pixel to the left, and for palettes none.
    private const val FILTER_NONE = 0
    private const val FILTER_SUB = 1

    // Files are 2 to 6 % larger than at level 9, which takes four to seven times as long.
    private const val LEVEL = 7

    /** The PNG file of [image]. */
    public fun encode(image: ImageData): ByteArray {
        val palette = palette(image)
        val pixels = if (palette == null) rgb(image) else indices(image, palette)
        val bytesPerPixel = if (palette == null) 3 else 1
        val file = ByteArrayOutputStream()
        file.write(SIGNATURE)
        file.chunk("IHDR") {
            writeInt(image.width)
            writeInt(image.height)
            writeByte(8)
            writeByte(if (palette == null) COLOR_TYPE_RGB else COLOR_TYPE_PALETTE)
            // Deflate, filters a row, not interlaced: nothing else is defined but the last.
            write(byteArrayOf(0, 0, 0))
        }
        if (palette !=
            null
        ) {
            file.chunk("PLTE") { palette.forEach { write(byteArrayOf((it shr 16).toByte(), (it shr 8).toByte(), it.toByte())) } }
        }
        val filter = if (palette == null) FILTER_SUB else FILTER_NONE
        file.chunk("IDAT") { write(pack(pixels, image.width * bytesPerPixel, bytesPerPixel, filter)) }
        file.chunk("IEND") {}
        return file.toByteArray()
    }

    /** The colours of [image] as 0xRRGGBB from dark to bright, so that a colour map's neighbours stay neighbours; null for too many. */
    private fun palette(image: ImageData): List<Int>? {
        val colors = HashSet<Int>()
        for (pixel in 0 until image.width * image.height) if (colors.add(color(image, pixel)) && colors.size > PALETTE_SIZE) return null
        return colors.sortedBy { (it shr 16) + (it shr 8 and 0xFF) + (it and 0xFF) }
    }

    private fun color(image: ImageData, pixel: Int): Int {
        fun channel(i: Int) = image.rgba[4 * pixel + i].toInt() and 0xFF
        return (channel(0) shl 16) or (channel(1) shl 8) or channel(2)
    }

    private fun indices(image: ImageData, palette: List<Int>): ByteArray {
        val index = palette.withIndex().associate { it.value to it.index.toByte() }
        return ByteArray(image.width * image.height) { index.getValue(color(image, it)) }
    }

    private fun rgb(image: ImageData) = ByteArray(3 * image.width * image.height) { image.rgba[it / 3 * 4 + it % 3] }

    private fun pack(pixels: ByteArray, rowSize: Int, bytesPerPixel: Int, filter: Int): ByteArray {
        val bytes = ByteArrayOutputStream()
        val deflater = Deflater(LEVEL)
        DeflaterOutputStream(bytes, deflater, BUFFER_SIZE).use { stream ->
            val row = ByteArray(1 + rowSize)
            row[0] = filter.toByte()
            for (start in pixels.indices step rowSize) {
                for (i in 0 until rowSize) {
                    val left = if (filter == FILTER_SUB && i >= bytesPerPixel) pixels[start + i - bytesPerPixel] else 0
                    row[1 + i] = (pixels[start + i] - left).toByte()
                }
                stream.write(row)
            }
        }
        deflater.end()
        return bytes.toByteArray()
    }

    private fun ByteArrayOutputStream.chunk(type: String, content: DataOutputStream.() -> Unit) {
        val data = ByteArrayOutputStream()
        data.write(type.toByteArray())
        DataOutputStream(data).content()
        val bytes = data.toByteArray()
        with(DataOutputStream(this)) {
            writeInt(bytes.size - type.length)
            write(bytes)
            writeInt(CRC32().apply { update(bytes) }.value.toInt())
        }
    }
}

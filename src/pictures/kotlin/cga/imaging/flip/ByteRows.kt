package cga.imaging.flip

import cga.framework.image.ImageData
import kotlin.math.pow

/** An sRGB picture of 8 bits a channel. */
internal class ByteRows(private val image: ImageData) : LinearRows {
    override val width: Int get() = image.width
    override val height: Int get() = image.height

    override fun read(
        y: Int,
        row: ColorRow,
    ) {
        val rgba = image.rgba
        var at = 4 * y * width
        for (x in 0 until width) {
            row.first[x] = LINEAR[rgba[at].toInt() and 255]
            row.second[x] = LINEAR[rgba[at + 1].toInt() and 255]
            row.third[x] = LINEAR[rgba[at + 2].toInt() and 255]
            at += 4
        }
    }

    private companion object {
        /** sRGB's transfer function (IEC 61966-2-1). */
        val LINEAR = FloatArray(256) {
            val value = it / 255.0
            (if (value <= 0.04045) value / 12.92 else ((value + 0.055) / 1.055).pow(2.4)).toFloat()
        }
    }
}

package cga.grading.analysis

import cga.framework.image.ImageData

/** How large a picture of a report is, with [grid]² samples a pixel. */
internal class PictureSize(
    val width: Int,
    val height: Int,
    val grid: Int,
) {
    /** The opaque picture of this size of one that is [grid] times as wide and high. */
    fun reduced(rgba: ByteArray): ImageData {
        val samples = grid * grid
        val result = ByteArray(4 * width * height)
        for (i in result.indices) {
            val (x, y) = i / 4 % width to i / 4 / width
            var sum = samples / 2
            for (s in 0 until samples) {
                sum +=
                    rgba[4 * ((y * grid + s / grid) * width * grid + x * grid + s % grid) + i % 4].toInt() and 0xFF
            }
            result[i] = if (i % 4 == 3) -1 else (sum / samples).toByte()
        }
        return ImageData(width, height, result)
    }
}

package cga.imaging.report

import cga.framework.image.ImageData
import cga.imaging.Pixel

/** A rectangle of pixels; [x] and [y] are its upper left corner. */
public data class Region(
    val x: Int,
    val y: Int,
    val width: Int,
    val height: Int,
) {
    public operator fun contains(other: Region): Boolean =
        other.x >= x && other.y >= y && other.x + other.width <= x + width && other.y + other.height <= y + height

    /** These pixels of [image]. */
    public fun cut(image: ImageData): ImageData {
        val rgba = ByteArray(4 * width * height)
        for (row in 0 until height) {
            image.rgba.copyInto(
                rgba,
                4 * width * row,
                4 * ((y + row) * image.width + x),
                4 * ((y + row) * image.width + x + width),
            )
        }
        return ImageData(width, height, rgba)
    }

    public companion object {
        /** The one pixel [at]. */
        public fun of(at: Pixel): Region = Region(at.x, at.y, 1, 1)

        /** [size]×[size] pixels about the middle of [region], moved and at last cut to lie in a picture of [width]×[height]. */
        public fun around(region: Region, size: Int, width: Int, height: Int): Region {
            fun start(from: Int, length: Int, limit: Int) = (from + length / 2 - size / 2).coerceIn(0, maxOf(0, limit - size))
            return Region(
                start(region.x, region.width, width),
                start(region.y, region.height, height),
                minOf(size, width),
                minOf(size, height),
            )
        }
    }
}

package cga.measure.mutation

import cga.framework.image.FloatImage
import cga.framework.image.ImageData

// Pictures as a mutant leaves them, and the small tools to write one down. Colours are linear in 0..1; alpha stays.

/** The picture in which pixel (x, y), rows from the top, is taken from [source] of it; outside of the picture it is black. */
internal fun FloatImage.taken(source: (x: Int, y: Int) -> Pair<Int, Int>): FloatImage =
    map { x, y, channel ->
        val (fromX, fromY) = source(x, y)
        if (fromX in 0 until width && fromY in 0 until height) this[fromX, fromY, channel] else 0f
    }

/** The picture with [color] (x, y, channel 0..2) as its numbers. */
internal fun FloatImage.map(color: FloatImage.(x: Int, y: Int, channel: Int) -> Float): FloatImage {
    val mapped = rgba.copyOf()
    for (y in 0 until height) {
        for (x in 0 until width) {
            for (channel in 0..2) mapped[4 * (y * width + x) + channel] = color(x, y, channel)
        }
    }
    return FloatImage(width, height, mapped)
}

internal operator fun FloatImage.get(
    x: Int,
    y: Int,
    channel: Int,
): Float = rgba[4 * (y * width + x) + channel]

/** The same picture as floats, 255 as 1. */
internal fun ImageData.toFloats(): FloatImage =
    FloatImage(width, height, FloatArray(rgba.size) { (rgba[it].toInt() and 0xFF) / 255f })

/** The nearest 8-bit picture. */
internal fun FloatImage.toBytes(): ImageData =
    ImageData(width, height, ByteArray(rgba.size) { Math.round(rgba[it].coerceIn(0f, 1f) * 255f).toByte() })

/** A number in 0..1 that looks random and is always the same (a 32-bit integer hash: Wellons, lowbias32, 2018). */
internal fun noise(seed: Int): Float {
    var x = seed
    x = (x xor (x ushr 16)) * 0x7feb352d
    x = (x xor (x ushr 15)) * -0x7b935975
    return (x xor (x ushr 16)).ushr(8) / 16777216f
}

/** The texture moved [dx] texels to the right, those pushed out coming in on the left, as a repeating texture goes on. */
internal fun ImageData.moved(dx: Int): ImageData = repainted { x, y -> texel(Math.floorMod(x - dx, width), y) }

/** The texture with [color] as its texels, red, green and blue alike. */
internal fun ImageData.repainted(color: ImageData.(x: Int, y: Int) -> Int): ImageData =
    ImageData(width, height, ByteArray(rgba.size) { if (it % 4 == 3) -1 else color(it / 4 % width, it / 4 / width).toByte() })

/** Red of a texel, which in our textures is green and blue too. */
internal fun ImageData.texel(
    x: Int,
    y: Int,
): Int = rgba[4 * (y * width + x)].toInt() and 0xFF

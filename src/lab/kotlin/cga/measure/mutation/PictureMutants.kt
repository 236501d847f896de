package cga.measure.mutation

import cga.framework.image.FloatImage

private fun Part.picture(
    name: String,
    change: (FloatImage) -> FloatImage,
) = Mutant(this, name, picture = change)

/** [levels]/255 added to one pixel of a thousand, here and there. */
private fun FloatImage.withScatteredPixels(levels: Float) =
    map { x, y, channel -> this[x, y, channel] + if (noise(y * width + x) < 0.001f) levels / 255f else 0f }

/** [levels]/255 added to the square of [size] pixels whose upper left corner is the given one. */
private fun FloatImage.withBlock(
    left: Int,
    top: Int,
    size: Int,
    levels: Float,
) = map { x, y, channel -> this[x, y, channel] + if (x - left in 0 until size && y - top in 0 until size) levels / 255f else 0f }

internal val PICTURE_MUTANTS: List<Mutant> =
    with(Part.PICTURE) {
        listOf(
            picture("mirrored") { image -> image.taken { x, y -> image.width - 1 - x to y } },
            picture("upside down") { image -> image.taken { x, y -> x to image.height - 1 - y } },
            picture("one pixel to the right") { image -> image.taken { x, y -> x - 1 to y } },
            picture("last row missing") { image -> image.taken { x, y -> if (y == image.height - 1) -1 to -1 else x to y } },
            picture("red and blue swapped") { image -> image.map { x, y, channel -> this[x, y, 2 - channel] } },
            picture("1/255 added everywhere") { image -> image.map { x, y, channel -> this[x, y, channel] + 1f / 255f } },
            picture("noise of ±1/255") { image ->
                // One of −1, 0 and 1.
                image.map { x, y, channel -> this[x, y, channel] + ((3 * noise(3 * (y * width + x) + channel)).toInt() - 1) / 255f }
            },
            picture("one white pixel in the sky") { image -> image.withBlock(120, 20, 1, levels = 255f) },
            picture("one pixel of 1000 1/255 brighter") { it.withScatteredPixels(levels = 1f) },
            picture("one pixel of 1000 3/255 brighter") { it.withScatteredPixels(levels = 3f) },
            picture("one pixel of 1000 8/255 brighter") { it.withScatteredPixels(levels = 8f) },
            picture("8×8 pixels of the sky 2/255 brighter") { image -> image.withBlock(120, 20, 8, levels = 2f) },
            picture("8×8 pixels of the sky 4/255 brighter") { image -> image.withBlock(120, 20, 8, levels = 4f) },
            picture("8×8 pixels of the sky 16/255 brighter") { image -> image.withBlock(120, 20, 8, levels = 16f) },
            fragment("alpha of one half", "vec3(inverseGamma)), 1.0);", "vec3(inverseGamma)), 0.5);"),
        )
    }

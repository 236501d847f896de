package cga.framework.image

import cga.framework.Home
import cga.framework.Phases
import cga.framework.cooked.Cooked

/**
 * A texture as OpenGL sees it: mip levels from the full size down to 1×1 (or the full size alone), four bytes a texel,
 * rows from bottom to top, so that row 0 lies at t = 0.
 *
 * The levels are made here and not by `glGenerateMipmap`, whose filter OpenGL leaves open: every driver and the CPU reference
 * sample the same numbers. Each level is the box filter of the one above, rounded to the nearest 1/255; an odd last row or column
 * is left out (none is for power-of-two sizes, which ours are).
 */
public class TextureImage(public val levels: List<Level>) {
    public constructor(image: ImageData, mipmaps: Boolean) : this(levels(image, mipmaps))

    /** One mip level. */
    public class Level(
        public val width: Int,
        public val height: Int,
        public val rgba: ByteArray,
    )

    public companion object {
        /** The texture in the picture file at [path], see [ImageData.read]. */
        public fun read(
            path: String,
            mipmaps: Boolean,
        ): TextureImage = Phases.span("texture") { load(path, mipmaps) }

        private fun load(
            path: String,
            mipmaps: Boolean,
        ): TextureImage {
            val file = Home.resolve(path)
            val form = if (mipmaps) "mipmaps" else "texture"
            return Cooked.read(file, form, CookedTexture::decode)
                ?: Cooked.make(listOf(file), form, CookedTexture::encode) { TextureImage(ImageData.read(path), mipmaps) }
        }

        private fun levels(
            image: ImageData,
            mipmaps: Boolean,
        ): List<Level> =
            generateSequence(flipped(image)) { level ->
                if (mipmaps && (level.width > 1 || level.height > 1)) halved(level) else null
            }.toList()

        private fun flipped(image: ImageData): Level {
            val row = 4 * image.width
            val rgba = ByteArray(image.rgba.size)
            for (y in 0 until image.height) image.rgba.copyInto(rgba, y * row, (image.height - 1 - y) * row, (image.height - y) * row)
            return Level(image.width, image.height, rgba)
        }

        private fun halved(from: Level): Level {
            val width = maxOf(1, from.width / 2)
            val height = maxOf(1, from.height / 2)
            val to = Level(width, height, ByteArray(4 * width * height))
            for (y in 0 until to.height) {
                val lower = 4 * from.width * minOf(2 * y, from.height - 1)
                val upper = 4 * from.width * minOf(2 * y + 1, from.height - 1)
                for (x in 0 until to.width) {
                    val left = 4 * minOf(2 * x, from.width - 1)
                    val right = 4 * minOf(2 * x + 1, from.width - 1)
                    for (c in 0 until 4) {
                        val sum = from[lower + left + c] + from[lower + right + c] + from[upper + left + c] + from[upper + right + c]
                        to.rgba[4 * (y * to.width + x) + c] = ((sum + 2) shr 2).toByte()
                    }
                }
            }
            return to
        }

        private operator fun Level.get(index: Int): Int = rgba[index].toInt() and 0xFF
    }
}

package cga.framework.image

import cga.framework.Home
import cga.framework.Phases
import cga.framework.cooked.Cooked
import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * A texture as OpenGL sees it: mip levels from the full size down to 1×1 (or the full size alone), four bytes a texel,
 * rows from bottom to top, so that row 0 lies at t = 0.
 *
 * The levels are made here and not by `glGenerateMipmap`, whose filter OpenGL leaves open: every driver and the CPU reference
 * sample the same numbers. Each level is the mean of the full picture's texels, rounded once to the nearest 1/255; an odd last row or
 * column is left out (none is for power-of-two sizes, which ours are).
 *
 * @param color the exact colour, linear RGB, of a texture that has one colour only and is no picture; else null. It may exceed 1.
 */
public class TextureImage private constructor(
    public val levels: List<Level>,
    public val color: Vector3fc?,
) {
    public constructor(levels: List<Level>) : this(levels, null)
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

        /** A texture of one [color], linear RGB, which is kept as it is. */
        public fun ofColor(color: Vector3fc): TextureImage =
            TextureImage(levels(ImageData.ofColor(color.x(), color.y(), color.z()), mipmaps = false), Vector3f(color))

        private fun levels(
            image: ImageData,
            mipmaps: Boolean,
        ): List<Level> = flipped(image).let { if (mipmaps) MipLevels.of(it) else listOf(it) }

        private fun flipped(image: ImageData): Level {
            val row = 4 * image.width
            val rgba = ByteArray(image.rgba.size)
            for (y in 0 until image.height) image.rgba.copyInto(rgba, y * row, (image.height - 1 - y) * row, (image.height - y) * row)
            return Level(image.width, image.height, rgba)
        }
    }
}

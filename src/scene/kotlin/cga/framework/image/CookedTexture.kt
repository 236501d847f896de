package cga.framework.image

import java.nio.ByteBuffer
import java.nio.ByteOrder.LITTLE_ENDIAN

/**
 * A texture as a cooked file's payload: an int, the number of its levels; of each its width and height as ints, and four bytes a texel.
 */
public object CookedTexture {
    public fun encode(image: TextureImage): ByteBuffer {
        val size = Int.SIZE_BYTES + image.levels.sumOf { 2 * Int.SIZE_BYTES + it.rgba.size }
        val bytes = ByteBuffer.allocate(size).order(LITTLE_ENDIAN).putInt(image.levels.size)
        for (level in image.levels) bytes.putInt(level.width).putInt(level.height).put(level.rgba)
        return bytes.flip()
    }

    public fun decode(bytes: ByteBuffer): TextureImage =
        TextureImage(
            List(bytes.getInt()) {
                val width = bytes.getInt()
                val height = bytes.getInt()
                TextureImage.Level(width, height, ByteArray(4 * width * height).also { bytes.get(it) })
            },
        )
}

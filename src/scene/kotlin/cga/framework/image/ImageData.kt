package cga.framework.image

import cga.framework.Home
import cga.framework.InputError
import org.lwjgl.stb.STBImage
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil
import java.nio.ByteBuffer

/** An 8-bit picture: [rgba] holds four bytes a pixel, rows from top to bottom. */
public class ImageData(
    public val width: Int,
    public val height: Int,
    public val rgba: ByteArray,
) {
    init {
        require(width > 0 && height > 0 && rgba.size == 4 * width * height) {
            "an RGBA picture of ${width}x$height takes ${4L * width * height} bytes, not ${rgba.size}"
        }
    }

    public companion object {
        /** One pixel of the given colour, each channel in 0..1 (clamped). */
        public fun ofColor(
            red: Float,
            green: Float,
            blue: Float,
        ): ImageData = ImageData(1, 1, byteArrayOf(toByte(red), toByte(green), toByte(blue), -1))

        /** Decodes the PNG, JPEG, TGA, … file at [path] (see [Home]) with stb_image. Throws [InputError] naming the file. */
        public fun read(path: String): ImageData {
            val file = Home.resolve(path)
            val bytes = Home.read(file, "texture")
            val encoded = MemoryUtil.memAlloc(bytes.size)
            return try {
                encoded.put(bytes).flip()
                if (STBImage.stbi_is_16_bit_from_memory(encoded)) {
                    throw InputError("texture file $file has 16 bits a channel, and textures have 8: save it with 8 bits a channel.")
                }
                decode(encoded) ?: throw InputError(
                    "texture file $file is not a readable picture (${STBImage.stbi_failure_reason()}): save it again as PNG.",
                )
            } finally {
                MemoryUtil.memFree(encoded)
            }
        }

        private fun decode(encoded: ByteBuffer): ImageData? =
            MemoryStack.stackPush().use { stack ->
                val width = stack.mallocInt(1)
                val height = stack.mallocInt(1)
                val pixels = STBImage.stbi_load_from_memory(encoded, width, height, stack.mallocInt(1), 4) ?: return null
                val rgba = ByteArray(pixels.remaining())
                pixels.get(rgba)
                STBImage.stbi_image_free(pixels.rewind())
                ImageData(width[0], height[0], rgba)
            }

        private fun toByte(value: Float): Byte = Math.round(value.coerceIn(0f, 1f) * 255f).toByte()
    }
}

package cga.imaging.golden

import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import java.nio.ByteBuffer
import java.security.MessageDigest

/** Collects numbers and bytes into a SHA-256 hash; the same on every machine. */
public class Checksum {
    private val digest = MessageDigest.getInstance("SHA-256")
    private val buffer = ByteBuffer.allocate(Int.SIZE_BYTES)

    public fun add(bytes: ByteArray): Checksum = apply { digest.update(bytes) }

    public fun add(text: String): Checksum = add(text.length).add(text.encodeToByteArray())

    public fun add(number: Int): Checksum = add(buffer.putInt(0, number).array())

    /** Bit for bit, but −0 as 0. */
    public fun add(number: Float): Checksum = add((number + 0f).toRawBits())

    /** The hash in hexadecimal digits: the first 32 of 64, which is plenty against chance. */
    public fun hex(): String = digest.digest().take(16).joinToString("") { "%02x".format(it) }

    internal companion object {
        /** Of the size and the stored numbers of [picture], however a file compresses them. */
        fun of(picture: Picture): String {
            val sum = Checksum().add(picture.width).add(picture.height)
            when (picture) {
                is BytePicture -> sum.add(picture.image.rgba)
                is FloatPicture -> sum.add(bits(picture.image.rgba))
            }
            return sum.hex()
        }

        private fun bits(numbers: FloatArray): ByteArray =
            ByteArray(numbers.size * Float.SIZE_BYTES).also { ByteBuffer.wrap(it).asFloatBuffer().put(numbers) }
    }
}

package cga.imaging.golden

import cga.framework.image.FloatImage
import cga.imaging.FloatPicture
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test

class ChecksumTest {
    @Test
    fun `it is the beginning of SHA-256`() {
        // FIPS 180-2, example B.1.
        assertEquals("ba7816bf8f01cfea414140de5dae2223", Checksum().add("abc".encodeToByteArray()).hex())
    }

    @Test
    fun `any number, its place and the end of a text count, but not the sign of zero`() {
        val sums =
            listOf(
                Checksum().add(1f).add(2f), Checksum().add(2f).add(1f), Checksum().add(1f), Checksum().add(1f).add(Math.nextUp(2f)),
                Checksum().add("ab").add("c"), Checksum().add("a").add("bc"),
            ).map { it.hex() }
        assertEquals(sums.size, sums.toSet().size)
        assertEquals(Checksum().add(0f).hex(), Checksum().add(-0f).hex())
    }

    @Test
    fun `a picture's size and every number of it count`() {
        assertNotEquals(Checksum.of(grey(5, width = 8)), Checksum.of(grey(6, width = 8)))
        assertNotEquals(Checksum.of(floats(2, 3, 1f)), Checksum.of(floats(3, 2, 1f)))
        assertNotEquals(Checksum.of(floats(2, 3, 1f)), Checksum.of(floats(2, 3, Math.nextUp(1f))))
    }

    private fun floats(
        width: Int,
        height: Int,
        first: Float,
    ) = FloatPicture.opaque(FloatImage(width, height, FloatArray(4 * width * height).also { it[0] = first }))
}

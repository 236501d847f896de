package cga.framework.image

import cga.framework.image.TextureImage.Level

/**
 * The smaller levels of a texture, by box filters. What is carried from level to level are exact sums, so that each level is the mean of
 * the full picture, rounded once: rounding what is rounded already makes a picture brighter from level to level. A mean half way between two
 * numbers goes to the even one, for always rounding it up would brighten too.
 *
 * @param step how often the picture was halved: [sums] are those of 4^step texels, channel by channel.
 */
internal class MipLevels private constructor(
    private val width: Int,
    private val height: Int,
    private val step: Int,
    private val sums: LongArray,
) {
    private fun mean(): Level = Level(width, height, ByteArray(sums.size) { rounded(sums[it], 2 * step).toByte() })

    /** The next level, or null behind 1×1. Of an odd number of rows or columns the last is left out; a single one is taken twice. */
    private fun halved(): MipLevels? {
        if (width == 1 && height == 1) return null
        val half = MipLevels(maxOf(1, width / 2), maxOf(1, height / 2), step + 1, LongArray(4 * maxOf(1, width / 2) * maxOf(1, height / 2)))
        for (y in 0 until half.height) for (x in 0 until half.width) half.sumUp(this, x, y)
        return half
    }

    private fun sumUp(
        from: MipLevels,
        x: Int,
        y: Int,
    ) {
        val left = 4 * minOf(2 * x, from.width - 1)
        val right = 4 * minOf(2 * x + 1, from.width - 1)
        val lower = 4 * from.width * minOf(2 * y, from.height - 1)
        val upper = 4 * from.width * minOf(2 * y + 1, from.height - 1)
        for (c in 0 until 4) {
            val below = from.sums[lower + left + c] + from.sums[lower + right + c]
            val above = from.sums[upper + left + c] + from.sums[upper + right + c]
            sums[4 * (y * width + x) + c] = below + above
        }
    }

    companion object {
        /** [full] and all smaller levels, down to 1×1. */
        fun of(full: Level): List<Level> {
            val sums = MipLevels(full.width, full.height, 0, LongArray(full.rgba.size) { full.rgba[it].toLong() and 0xFF })
            return generateSequence(sums) { it.halved() }.map { it.mean() }.toList()
        }

        /** [sum] / 2^[bits], to the nearest integer. */
        private fun rounded(
            sum: Long,
            bits: Int,
        ): Long {
            if (bits == 0) return sum
            val half = 1L shl (bits - 1)
            val isTie = sum and ((half shl 1) - 1) == half
            val up = (sum + half) shr bits
            return if (isTie) up and 1L.inv() else up
        }
    }
}

package cga.reference

/**
 * What a texture is beyond its edges: which texel of a row of `size` is taken for the coordinate i, any whole number
 * (OpenGL 3.3 core, table 3.18). [BORDER] stands for the border, which is black.
 */
public enum class WrapMode(private val gl: Int) {
    CLAMP_TO_EDGE(0x812F) {
        override fun texel(
            i: Long,
            size: Int,
        ) = i.coerceIn(0L, size - 1L).toInt()
    },
    CLAMP_TO_BORDER(0x812D) {
        override fun texel(
            i: Long,
            size: Int,
        ) = if (i in 0 until size) i.toInt() else BORDER
    },
    REPEAT(0x2901) {
        override fun texel(
            i: Long,
            size: Int,
        ) = Math.floorMod(i, size)
    },
    MIRRORED_REPEAT(0x8370) {
        override fun texel(
            i: Long,
            size: Int,
        ): Int {
            val inTwo = Math.floorMod(i, 2 * size)
            return if (inTwo < size) inTwo else 2 * size - 1 - inTwo
        }
    }, ;

    public abstract fun texel(
        i: Long,
        size: Int,
    ): Int

    public companion object {
        public const val BORDER: Int = -1

        /** The mode that OpenGL's constant [gl] names. Throws [IllegalArgumentException]. */
        public fun of(gl: Int): WrapMode =
            requireNotNull(entries.find { it.gl == gl }) { "wrap mode 0x%X is none of ${entries.joinToString()}".format(gl) }
    }
}

package cga.reference

/**
 * How a texture is filtered, under OpenGL's names: the texels of a level ([isLinear]: the four around the point, weighted, else the nearest),
 * and the levels.
 */
public enum class TextureFilter(
    private val gl: Int,
    public val isLinear: Boolean,
    public val levels: Levels,
) {
    NEAREST(0x2600, isLinear = false, Levels.FIRST),
    LINEAR(0x2601, isLinear = true, Levels.FIRST),
    NEAREST_MIPMAP_NEAREST(0x2700, isLinear = false, Levels.NEAREST),
    LINEAR_MIPMAP_NEAREST(0x2701, isLinear = true, Levels.NEAREST),
    NEAREST_MIPMAP_LINEAR(0x2702, isLinear = false, Levels.BETWEEN),
    LINEAR_MIPMAP_LINEAR(0x2703, isLinear = true, Levels.BETWEEN),
    ;

    /** Which mip levels are looked at. */
    public enum class Levels {
        /** The full size only. */
        FIRST,

        /** The one whose size suits best. */
        NEAREST,

        /** The next larger and the next smaller, weighted. */
        BETWEEN,
    }

    public companion object {
        /** The filter that OpenGL's constant [gl] names. Throws [IllegalArgumentException]. */
        public fun of(gl: Int): TextureFilter =
            requireNotNull(entries.find { it.gl == gl }) { "texture filter 0x%X is none of ${entries.joinToString()}".format(gl) }
    }
}

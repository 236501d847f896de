package cga.measure.accuracy

import cga.exercise.game.Step

/** Which pixels of which picture are counted, against which truth. */
public enum class TexelGroup(public val title: String) {
    /** All pixels of a picture with textures that have no mip levels: λ plays no part. */
    FIRST_LEVEL("All pixels, textures without mip levels"),

    /** No texture is minified, whichever λ of those that OpenGL allows is taken. */
    MAGNIFIED("Pixels in which no texture is minified"),

    /** Some texture may be. */
    MINIFIED("Pixels in which a texture is minified"),

    /** All pixels, against a truth with the mip levels of llvmpipe: what is left are floats. */
    KNOWN_LEVELS("All pixels, the truth with llvmpipe's mip levels"),
}

/**
 * How far OpenGL is from the truth, over a group of the pixels in which both show the same triangle. An error is the largest of a pixel's
 * three channels, in units of 1/255.
 *
 * @param renderer what drew it, `GL_RENDERER`.
 * @param agreement share of the whole picture in which both show the same triangle, or none.
 * @param strays pixels that show another triangle than the truth although it is not within a sub-pixel step of the centre, or hidden.
 * @param checksum of the whole picture, so that two settings can be seen to change nothing.
 * @param pixels how many are counted; without any the numbers below are 0.
 * @param p999 99.9th percentile.
 * @param maxRelative error as a share of the pixel's brightest true channel, or of 1/255 where that is darker; [meanRelative] the mean.
 * @param worst column and row of the worst pixel, from the upper left.
 * @param term the term of the lighting model that is furthest off there, by [termError].
 * @param worstBound what was allowed there.
 * @param medianBound the median of what is allowed.
 * @param tightness the largest share that any pixel takes of its own bound: at most 1, or the bound does not hold.
 * @param unbounded pixels about which the bound says nothing.
 */
public data class GlFigure(
    public val renderer: String,
    public val step: Step,
    public val filtering: TextureFiltering,
    public val group: TexelGroup,
    public val agreement: Double,
    public val strays: Int,
    public val checksum: Long,
    public val pixels: Int,
    public val max: Double,
    public val p999: Double,
    public val mean: Double,
    public val maxRelative: Double,
    public val meanRelative: Double,
    public val worst: Pair<Int, Int>,
    public val term: String,
    public val termError: Double,
    public val worstBound: Double,
    public val medianBound: Double,
    public val tightness: Double,
    public val unbounded: Int,
) {
    internal val isLlvmpipe: Boolean get() = isLlvmpipe(renderer)

    internal companion object {
        fun isLlvmpipe(renderer: String): Boolean = "llvmpipe" in renderer
    }
}

package cga.measure.accuracy.choices

/** Width and height in pixels. */
public data class PictureSize(
    public val width: Int,
    public val height: Int,
) {
    /** A quarter of both, for pictures of which the truth takes 256 samples a pixel. */
    internal val small: PictureSize get() = PictureSize(maxOf(width / 4, 1), maxOf(height / 4, 1))

    internal val pixels: Int get() = width * height

    internal fun times(factor: Int) = PictureSize(width * factor, height * factor)

    override fun toString(): String = "$width×$height"
}

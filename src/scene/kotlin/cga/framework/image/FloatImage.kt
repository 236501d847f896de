package cga.framework.image

/** A picture of 32-bit floats: [rgba] holds four numbers a pixel, linear, unclamped, rows from top to bottom. */
public class FloatImage(
    public val width: Int,
    public val height: Int,
    public val rgba: FloatArray,
) {
    init {
        require(width > 0 && height > 0 && rgba.size == 4 * width * height) {
            "an RGBA picture of ${width}x$height takes ${4L * width * height} numbers, not ${rgba.size}"
        }
    }
}

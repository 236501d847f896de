package cga.imaging.report

import cga.framework.image.ImageData
import java.util.Base64

/**
 * A picture that a page carries. It is on the page once, as the `<img>` with this [id]; the page's script shows it again wherever
 * a widget names that id.
 *
 * @param alt what a reader who does not see it is told.
 */
public class EmbeddedPicture(
    public val id: String,
    public val alt: String,
    image: ImageData,
    private val shrink: Shrink = Shrink.MEAN,
) {
    /** What is drawn: the picture, or a smaller one after [halve]. */
    private var drawn = image

    private var png = SmallPng.encode(image)

    /** Of the picture itself. */
    public val width: Int = image.width
    public val height: Int = image.height

    /** By how much less wide and high it is drawn than it is: 1, 2, 4, … */
    public var reduction: Int = 1
        private set

    /** Bytes that it takes on the page. */
    public val size: Int get() = (png.size + 2) / 3 * 4

    /** The picture as an address that carries it. */
    public val url: String get() = "data:image/png;base64," + Base64.getEncoder().encodeToString(png)

    /** Draws it with half its present width and height. */
    public fun halve() {
        drawn = shrink.halve(drawn)
        png = SmallPng.encode(drawn)
        reduction *= 2
    }
}

/** What becomes of two by two pixels. */
public enum class Shrink {
    /** Their mean. */
    MEAN,

    /** The brightest of them: no new colours in a picture of a colour map, and no error of one pixel is lost. */
    BRIGHTEST,
    ;

    /** [image] with half its width and height, rounded up. */
    public fun halve(image: ImageData): ImageData {
        val width = (image.width + 1) / 2
        val height = (image.height + 1) / 2
        val rgba = ByteArray(4 * width * height)
        for (y in 0 until height) {
            for (x in 0 until width) {
                val right = minOf(2 * x + 1, image.width - 1)
                val below = minOf(2 * y + 1, image.height - 1)
                val four = listOf(2 * y, below).flatMap { row -> listOf(row * image.width + 2 * x, row * image.width + right) }
                join(image.rgba, four).copyInto(rgba, 4 * (y * width + x))
            }
        }
        return ImageData(width, height, rgba)
    }

    private fun join(rgba: ByteArray, pixels: List<Int>): ByteArray {
        fun channel(pixel: Int, i: Int) = rgba[4 * pixel + i].toInt() and 0xFF
        return when (this) {
            MEAN -> ByteArray(4) { i -> ((pixels.sumOf { channel(it, i) } + 2) / 4).toByte() }
            BRIGHTEST -> pixels.maxBy { channel(it, 0) + channel(it, 1) + channel(it, 2) }.let { ByteArray(4) { i -> rgba[4 * it + i] } }
        }
    }
}

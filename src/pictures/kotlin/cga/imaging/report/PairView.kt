package cga.imaging.report

import cga.framework.image.ImageData
import cga.imaging.Comparison
import cga.imaging.Pixel
import cga.imaging.flip.FlipMap
import kotlin.math.abs
import kotlin.math.roundToInt

/** The pictures of a case whose two differ, made ready. */
internal class PairView(
    private val id: String,
    private val name: String,
    val comparison: Comparison,
    display: Display,
) {
    private val expectedImage = display.draw(comparison.expected)
    private val actualImage = display.draw(comparison.actual)

    val expected = EmbeddedPicture("$id-expected", "Expected picture of $name", expectedImage)
    val actual = EmbeddedPicture("$id-actual", "Actual picture of $name", actualImage)
    val flip = EmbeddedPicture("$id-flip", "ꟻLIP error map of $name", coarse(comparison.flip).magma(), Shrink.BRIGHTEST)

    /** Those that may have to be shrunk. */
    val pictures: List<EmbeddedPicture> get() = listOf(expected, actual, flip)

    // How many colour values differ by how many steps of a byte, as drawn.
    private val steps = IntArray(WHITE + 1)

    init {
        for (i in expectedImage.rgba.indices) {
            if (i % 4 != 3) steps[abs((expectedImage.rgba[i].toInt() and 0xFF) - (actualImage.rgba[i].toInt() and 0xFF))]++
        }
        steps[0] = 0
    }

    /** Whether anything of the difference is left in the pictures as they are drawn. */
    val isVisible: Boolean = steps.any { it > 0 }

    /** The largest of [GAINS] that keeps nine in ten of the differences on the screen's scale, so that faint ones are seen. */
    val gain: Int = largeDifference().let { most -> GAINS.last { it == 1 || it * most <= WHITE } }

    private val worstPixel: Pixel = checkNotNull(comparison.difference.worst) { "$name: pictures that differ have a worst pixel" }
    private val worstWindow: Region =
        comparison.worstWindow(Comparison.WINDOW).let {
            Region(it.corner.x, it.corner.y, minOf(it.size, expected.width), minOf(it.size, expected.height))
        }

    /** Where to look in the large pictures. */
    val marks: List<Mark> = listOf(Mark(worstWindow, ring = false), Mark(Region.of(worstPixel), ring = true))

    /** Places to look at closely: the worst pixel, and the worst window where that is elsewhere. */
    val zooms: List<ZoomView> = zooms()

    private fun zooms(): List<ZoomView> {
        val pixel = zoom("pixel", Region.of(worstPixel), "Worst pixel, at ${worstPixel.x}, ${worstPixel.y}", worstPixel)
        val window =
            zoom(
                "window",
                worstWindow,
                "Worst ${Comparison.WINDOW}×${Comparison.WINDOW} window, at ${worstWindow.x}, ${worstWindow.y}",
                null,
            )
        return if (worstWindow in pixel.region) listOf(pixel) else listOf(pixel, window)
    }

    private fun zoom(part: String, about: Region, title: String, pixel: Pixel?): ZoomView {
        val region = Region.around(about, ZOOM, expected.width, expected.height)

        fun cut(image: ImageData, which: String) =
            EmbeddedPicture(
                "$id-$part-$which",
                "${which.replaceFirstChar(Char::uppercase)} pixels of $name about the worst $part",
                region.cut(image),
            )
        return ZoomView(title, region, about, cut(expectedImage, "expected"), cut(actualImage, "actual"), pixel)
    }

    /** The difference that nine in ten of those that are not 0 do not exceed. */
    private fun largeDifference(): Int {
        var rest = steps.sum() / 10
        return (WHITE downTo 1).firstOrNull { step -> rest < steps[step].also { rest -= it } } ?: WHITE
    }

    /** In so few steps that the picture packs well, and so many that none is seen. */
    private fun coarse(flip: FlipMap) =
        FlipMap(flip.width, flip.height, FloatArray(flip.error.size) { (flip.error[it] * FLIP_STEPS).roundToInt() / FLIP_STEPS.toFloat() })

    companion object {
        /** Width and height of the window that is looked for. */
        private const val ZOOM = 24
        private const val WHITE = 255
        private const val FLIP_STEPS = 63
    }
}

/** A part of the pictures to be shown enlarged: [region], because of what [about] holds; [pixel] where that is a single one. */
internal class ZoomView(
    val title: String,
    val region: Region,
    val about: Region,
    val expected: EmbeddedPicture,
    val actual: EmbeddedPicture,
    val pixel: Pixel?,
) {
    /** [about], in the enlarged part's own coordinates. */
    val marks: List<Mark> = listOf(Mark(about.copy(x = about.x - region.x, y = about.y - region.y), ring = false))
}

package cga.imaging.report

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.FloatPicture
import cga.imaging.Severity
import kotlin.random.Random

// Pictures and cases to make reports of.

/** A case of two pictures, which differ where [expected] and [actual] do. */
internal fun caseOf(expected: BytePicture, actual: BytePicture, name: String = "a case", severity: Severity = Severity.FAIL) =
    ReportCase(name, severity, listOf("a message"), Comparison(expected, actual))

/** A picture whose bytes are [byte] of x, y and the channel. */
internal fun picture(width: Int, height: Int, byte: (Int, Int, Int) -> Int): BytePicture =
    BytePicture.opaque(ImageData(width, height, ByteArray(4 * width * height) { byte(it / 4 % width, it / 4 / width, it % 4).toByte() }))

/** Slow changes of colour from corner to corner, unlike its mirror image. */
internal fun gradient(width: Int, height: Int): BytePicture =
    picture(width, height) { x, y, channel -> listOf(200 * x / width, 200 * y / height, 100 * (x + y) / (width + height))[channel % 3] }

/** This picture with the red of one pixel raised by [change]. */
internal fun BytePicture.with(x: Int, y: Int, change: Int): BytePicture {
    val rgba = image.rgba.copyOf()
    rgba[4 * (y * width + x)] = (rgba[4 * (y * width + x)] + change).toByte()
    return BytePicture.opaque(ImageData(width, height, rgba))
}

/** This picture with every byte moved by a random whole number from −[most] to [most]. */
internal fun BytePicture.noisy(most: Int, random: Random): BytePicture =
    picture(width, height) { x, y, channel ->
        ((image.rgba[4 * (y * width + x) + channel].toInt() and 0xFF) + random.nextInt(-most, most + 1)).coerceIn(0, 255)
    }

/** This picture in floats, from 0 to [white]. */
internal fun BytePicture.floats(white: Float): FloatPicture =
    FloatPicture.opaque(FloatImage(width, height, FloatArray(4 * width * height) { (image.rgba[it].toInt() and 0xFF) / 255f * white }))

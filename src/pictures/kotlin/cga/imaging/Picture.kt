package cga.imaging

import cga.framework.InputError
import cga.framework.image.FloatImage
import cga.framework.image.ImageData

/** A picture to compare, rows from top to bottom. */
public sealed interface Picture {
    public val width: Int
    public val height: Int

    /** Whether the fourth channel says something; it is compared only then. */
    public val hasAlpha: Boolean
}

/** 8 bits a channel, as a screen shows it (sRGB where a metric needs colours). Without alpha, every alpha byte is 255. */
public class BytePicture(
    public val image: ImageData,
    override val hasAlpha: Boolean,
) : Picture {
    override val width: Int get() = image.width
    override val height: Int get() = image.height

    public companion object {
        /** The picture of a framebuffer, whose alpha means nothing. */
        public fun opaque(image: ImageData): BytePicture {
            val rgba = image.rgba.copyOf()
            for (i in 3 until rgba.size step 4) rgba[i] = -1
            return BytePicture(ImageData(image.width, image.height, rgba), hasAlpha = false)
        }
    }
}

/**
 * 32-bit floats, linear and unclamped. Without alpha, every alpha is 1.
 *
 * Every value is finite: a NaN is neither more nor less than anything and would pass every bound. Throws [InputError] where one is not.
 */
public class FloatPicture(
    public val image: FloatImage,
    override val hasAlpha: Boolean,
) : Picture {
    override val width: Int get() = image.width
    override val height: Int get() = image.height

    init {
        val wrong = image.rgba.count { !it.isFinite() }
        if (wrong > 0) {
            val at = image.rgba.indexOfFirst { !it.isFinite() }
            val place = "${CHANNELS[at % 4]} at x = ${at / 4 % width}, y = ${at / 4 / width}"
            val values = if (wrong == 1) "1 value is not finite" else "$wrong values are not finite, the first"
            throw InputError("$values: ${image.rgba[at]} in $place. Find out what made it; it cannot be compared.")
        }
    }

    public companion object {
        private val CHANNELS = listOf("red", "green", "blue", "alpha")

        /** The picture of a framebuffer, whose alpha means nothing. */
        public fun opaque(image: FloatImage): FloatPicture {
            val rgba = image.rgba.copyOf()
            for (i in 3 until rgba.size step 4) rgba[i] = 1f
            return FloatPicture(FloatImage(image.width, image.height, rgba), hasAlpha = false)
        }
    }
}

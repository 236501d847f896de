package cga.imaging.report

import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import kotlin.math.floor
import kotlin.math.log2
import kotlin.math.pow

/**
 * How the pictures of one case are drawn with 8 bits a channel, all alike: bytes as they are, floats scaled by two to the power of
 * [exposure], clamped and rounded, without gamma, as a framebuffer of bytes would hold them. Alpha is not drawn.
 *
 * @param exposure in stops; null for pictures of bytes.
 */
internal class Display private constructor(
    val exposure: Int?,
) {
    /** [picture] as it is drawn. */
    fun draw(picture: Picture): ImageData =
        when (picture) {
            is BytePicture -> picture.image
            is FloatPicture -> {
                val scale = 2f.pow(exposure ?: 0)
                val rgba = picture.image.rgba
                ImageData(
                    picture.width,
                    picture.height,
                    ByteArray(rgba.size) { ((rgba[it] * scale).coerceIn(0f, 1f) * 255 + 0.5f).toInt().toByte() },
                )
            }
        }

    companion object {
        private const val SHARE_NOT_CLAMPED = 0.99
        private const val MOST_STOPS = 60

        /** The brightest whole exposure at which 99 % of the pixels that are not black in [picture] are not clamped. */
        fun of(picture: Picture): Display {
            if (picture !is FloatPicture) return Display(null)
            val rgba = picture.image.rgba
            val sorted = FloatArray(rgba.size / 4) { maxOf(rgba[4 * it], rgba[4 * it + 1], rgba[4 * it + 2]) }.apply { sort() }
            val dark = sorted.count { it <= 0 }
            if (dark == sorted.size) return Display(0)
            val white = sorted[dark + ((sorted.size - 1 - dark) * SHARE_NOT_CLAMPED).toInt()]
            return Display(floor(-log2(white.toDouble())).toInt().coerceIn(-MOST_STOPS, MOST_STOPS))
        }
    }
}

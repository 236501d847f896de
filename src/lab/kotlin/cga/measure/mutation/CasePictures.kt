package cga.measure.mutation

import cga.exercise.game.ScriptedScene
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.FloatImage
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import cga.measure.golden.GoldenCase
import kotlin.math.abs

/**
 * A golden case as a renderer draws it.
 *
 * @param picture as the golden is stored: 8 bits a channel, or floats.
 * @param unquantised the same before it was rounded to 8 bits; but for antialiasing, where samples are rounded before they are averaged.
 */
internal class CasePictures(
    private val case: GoldenCase,
    val picture: Picture,
    val unquantised: FloatImage,
) {
    /** These pictures after [change] happened to them. */
    fun changed(change: (FloatImage) -> FloatImage): CasePictures {
        val changed =
            when (picture) {
                is BytePicture -> BytePicture(change(picture.image.toFloats()).toBytes(), picture.hasAlpha)
                is FloatPicture -> FloatPicture(change(picture.image), picture.hasAlpha)
            }
        return CasePictures(case, changed, change(unquantised))
    }

    /** How many pixels differ from [other] by at least 1/255 in a channel, before rounding; of an 8-bit picture what it can show counts. */
    fun visiblyDifferent(other: CasePictures): Int {
        val a = unquantised.rgba
        val b = other.unquantised.rgba

        fun difference(i: Int) = if (case.float) abs(a[i] - b[i]) else abs(a[i].coerceIn(0f, 1f) - b[i].coerceIn(0f, 1f))
        return (a.indices step 4).count { i -> (i..i + 2).any { difference(it) >= VISIBLE } }
    }

    companion object {
        /** 1/255, less the rounding of a float near 1 twice. */
        private const val VISIBLE = 1f / 255f - 1.2e-7f

        /** Draws [player], which is the scene of [case], in the current context. */
        fun draw(
            case: GoldenCase,
            player: ScriptedScene,
        ): CasePictures {
            val unquantised = draw(player, case, ColorFormat.RGBA32F) { readFloats() }
            val picture =
                if (case.float) {
                    FloatPicture.opaque(unquantised)
                } else {
                    BytePicture.opaque(draw(player, case, ColorFormat.RGBA8) { read() })
                }
            return CasePictures(case, picture, unquantised)
        }

        private fun <T> draw(
            player: ScriptedScene,
            case: GoldenCase,
            format: ColorFormat,
            pixels: RenderTarget.() -> T,
        ): T =
            RenderTarget(GoldenCase.WIDTH, GoldenCase.HEIGHT, case.samples, format).use { target ->
                target.bind()
                player.scene.render()
                target.pixels()
            }
    }
}

package cga.imaging.tolerance

import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.FloatPicture

/** A grey of 100 everywhere, but [value] in the first [pixels]. */
internal fun bytes(
    value: Int = 100,
    pixels: Int = 0,
    side: Int = 32,
): BytePicture = BytePicture.opaque(ImageData(side, side, ByteArray(4 * side * side) { (if (it / 4 < pixels) value else 100).toByte() }))

/** As [bytes], in floats around 1. */
internal fun floats(
    value: Float = 1f,
    pixels: Int = 0,
    side: Int = 32,
): FloatPicture = FloatPicture.opaque(FloatImage(side, side, FloatArray(4 * side * side) { if (it / 4 < pixels) value else 1f }))

/** Grey against the same with so many pixels of [value]. */
internal fun against(
    value: Int,
    pixels: Int = 1,
): Comparison = Comparison(bytes(), bytes(value, pixels))

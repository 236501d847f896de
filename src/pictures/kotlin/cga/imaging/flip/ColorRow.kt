package cga.imaging.flip

/** The three channels of a row of pixels, in whatever colour space. */
internal class ColorRow(width: Int) {
    val first: FloatArray = FloatArray(width)
    val second: FloatArray = FloatArray(width)
    val third: FloatArray = FloatArray(width)
}

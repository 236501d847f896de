package cga.imaging.flip

/** The rows of a plane up to [radius] above and below the one at work: a ring that the next rows overwrite. */
internal class RowWindow(
    width: Int,
    private val height: Int,
    radius: Int,
) {
    private val rows = Array(minOf(2 * radius + 1, height)) { FloatArray(width) }

    /** Row [y]; beyond the picture its outermost row, as the reference implementation continues pictures. */
    operator fun get(y: Int): FloatArray = rows[y.coerceIn(0, height - 1) % rows.size]
}

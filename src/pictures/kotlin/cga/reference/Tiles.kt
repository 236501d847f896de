package cga.reference

import kotlin.math.floor

/**
 * The picture cut into squares of [SIZE] pixels, each with the triangles that may be seen in it. Pixels are counted from the lower left
 * corner, as in the window.
 */
internal class Tiles(
    private val triangles: Triangles,
    private val width: Int,
    private val height: Int,
) {
    private val columns = (width + SIZE - 1) / SIZE
    private val rows = (height + SIZE - 1) / SIZE
    private val members: List<IntArray>

    /** How many there are. */
    val count: Int get() = columns * rows

    init {
        val lists = List(count) { ArrayList<Int>() }
        val projected = Projected()
        for (number in 0 until triangles.count) {
            projected.look(triangles, number)
            // Back faces are not drawn: the scene switches GL_CULL_FACE on.
            if (projected.isFront) sort(number, projected, lists)
        }
        members = lists.map { it.toIntArray() }
    }

    /** The tile that holds the pixel in column [x] and row [y]. */
    fun at(
        x: Int,
        y: Int,
    ): Int = y / SIZE * columns + x / SIZE

    /** The leftmost pixel of [tile]. */
    fun left(tile: Int): Int = tile % columns * SIZE

    /** The lowest pixel of [tile]. */
    fun bottom(tile: Int): Int = tile / columns * SIZE

    /** Pixels of [tile] in a row; fewer than [SIZE] at the right side of the picture. */
    fun width(tile: Int): Int = minOf(SIZE, width - left(tile))

    /** Rows of [tile]. */
    fun height(tile: Int): Int = minOf(SIZE, height - bottom(tile))

    /** The numbers of the triangles that may be seen in [tile], in drawing order. */
    fun triangles(tile: Int): IntArray = members[tile]

    private fun sort(
        number: Int,
        projected: Projected,
        lists: List<MutableList<Int>>,
    ) {
        for (row in tileAt(projected.bottom, rows)..tileAt(projected.top, rows)) {
            for (column in tileAt(projected.left, columns)..tileAt(projected.right, columns)) {
                val tile = row * columns + column
                if (projected.mayCover(left(tile), bottom(tile), width(tile), height(tile))) lists[tile] += number
            }
        }
    }

    private fun tileAt(
        pixel: Double,
        tiles: Int,
    ) = floor(pixel / SIZE).coerceIn(0.0, tiles - 1.0).toInt()

    companion object {
        /** Pixels on a side. */
        const val SIZE: Int = 16
    }
}

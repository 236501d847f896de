package cga.reference

import kotlin.math.ceil
import kotlin.math.floor

/**
 * Which triangle each sample of a tile shows: the depth test of OpenGL with `GL_LESS`, so that of two at the same depth the first one
 * drawn is seen. Filled again for every tile; each thread has its own.
 *
 * @param grid samples a pixel in a row and in a column, evenly spaced; 1 is the pixel's centre.
 */
internal class Visibility(
    private val triangles: Triangles,
    private val tiles: Tiles,
    private val grid: Int,
) {
    private val projected = Projected()
    private val stride = Tiles.SIZE * grid
    private val surface = IntArray(stride * stride)
    private val depth = DoubleArray(stride * stride)
    private var left = 0
    private var bottom = 0

    /** Takes [tile]. */
    fun look(tile: Int) {
        surface.fill(ReferencePicture.NO_SURFACE)
        depth.fill(1.0)
        left = tiles.left(tile)
        bottom = tiles.bottom(tile)
        for (number in tiles.triangles(tile)) draw(number, tiles.width(tile) * grid, tiles.height(tile) * grid)
    }

    /** The number of the triangle that the sample in column [x] and row [y] of the tile shows. */
    fun surface(
        x: Int,
        y: Int,
    ): Int = surface[y * stride + x]

    /** Its window depth; 1 where there is none. */
    fun depth(
        x: Int,
        y: Int,
    ): Double = depth[y * stride + x]

    /** Where in the window column [x] of the tile's samples is, and its row [y]. */
    fun windowX(x: Int): Double = left + (x + 0.5) / grid

    fun windowY(y: Int): Double = bottom + (y + 0.5) / grid

    private fun draw(
        number: Int,
        columns: Int,
        rows: Int,
    ) {
        projected.look(triangles, number)
        // One more on each side than rounding could ask for.
        val firstColumn = floor((projected.left - left) * grid - 1).coerceIn(0.0, columns.toDouble()).toInt()
        val lastColumn = ceil((projected.right - left) * grid).coerceIn(-1.0, columns - 1.0).toInt()
        val firstRow = floor((projected.bottom - bottom) * grid - 1).coerceIn(0.0, rows.toDouble()).toInt()
        val lastRow = ceil((projected.top - bottom) * grid).coerceIn(-1.0, rows - 1.0).toInt()
        for (y in firstRow..lastRow) {
            for (x in firstColumn..lastColumn) {
                projected.at(windowX(x), windowY(y))
                val sample = y * stride + x
                if (projected.covers && projected.depth < depth[sample]) {
                    depth[sample] = projected.depth
                    surface[sample] = number
                }
            }
        }
    }
}

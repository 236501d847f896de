package cga.reference

import cga.framework.Frame
import java.util.concurrent.atomic.AtomicInteger
import java.util.stream.IntStream

/**
 * The truth: shades a frame on the CPU in double precision, without OpenGL and without its formulas. What both start from (models, textures,
 * mip levels, camera, places of lights, constants) is checked by a third program, tests/glm/picture.cpp.
 *
 * It draws as the scene does: front faces only, `GL_LESS` depth test, no blending, black background. What OpenGL leaves to the driver is
 * taken at its ideal: vertices are not rounded to a grid of sub-pixels, depth is not rounded to 24 bits, and the mip level comes from
 * the exact derivatives at the sample and not from differences between neighbours.
 *
 * @param width of the picture in pixels; likewise [height].
 * Throws [IllegalArgumentException] where a texture's parameters are none of OpenGL's.
 */
public class ReferenceRenderer(
    private val frame: Frame,
    public val width: Int,
    public val height: Int,
) {
    private val triangles = Triangles(frame, width, height)
    private val tiles = Tiles(triangles, width, height)

    /**
     * The picture; the same numbers whatever the number of [threads].
     *
     * @param grid 1 for one sample in the centre of each pixel; n for the mean of n×n, evenly spaced: a picture n times as wide and high,
     * mip levels included, made smaller.
     */
    public fun render(
        grid: Int = 1,
        threads: Int = Runtime.getRuntime().availableProcessors(),
    ): ReferencePicture {
        require(grid >= 1 && threads >= 1) { "grid $grid and threads $threads must be at least 1" }
        val picture = ReferencePicture(width, height)
        val nextTile = AtomicInteger()
        IntStream.range(0, threads).parallel().forEach {
            val painter = Painter(picture, grid)
            generateSequence { nextTile.getAndIncrement().takeIf { it < tiles.count } }.forEach(painter::paint)
        }
        return picture
    }

    /** All that there is to say about the pixel in [column] and [row], from the upper left, at its centre; null where it shows nothing. */
    public fun probe(
        column: Int,
        row: Int,
    ): ShadedPoint? {
        require(column in 0 until width && row in 0 until height) { "there is no pixel ($column, $row) in a picture of ${width}x$height" }
        val y = height - 1 - row
        val tile = tiles.at(column, y)
        val visibility = Visibility(triangles, tiles, 1)
        visibility.look(tile)
        val number = visibility.surface(column - tiles.left(tile), y - tiles.bottom(tile))
        if (number == ReferencePicture.NO_SURFACE) return null
        val shader = FragmentShader(frame, triangles)
        return shader.newPoint().also { shader.shade(number, column + 0.5, y + 0.5, it) }
    }

    /** Paints tiles of [picture], one after the other; each thread has its own. */
    private inner class Painter(
        private val picture: ReferencePicture,
        private val grid: Int,
    ) {
        private val visibility = Visibility(triangles, tiles, grid)
        private val shader = FragmentShader(frame, triangles, 1.0 / grid)
        private val point = shader.newPoint()

        fun paint(tile: Int) {
            visibility.look(tile)
            for (y in 0 until tiles.height(tile)) {
                for (x in 0 until tiles.width(tile)) {
                    paint(x, y, (height - 1 - tiles.bottom(tile) - y) * width + tiles.left(tile) + x)
                }
            }
        }

        /** Paints the pixel in column [x] and row [y] of the tile. */
        private fun paint(
            x: Int,
            y: Int,
            pixel: Int,
        ) {
            picture.surface[pixel] = visibility.surface(x * grid + grid / 2, y * grid + grid / 2)
            picture.depth[pixel] = visibility.depth(x * grid + grid / 2, y * grid + grid / 2)
            for (j in y * grid until (y + 1) * grid) {
                for (i in x * grid until (x + 1) * grid) {
                    add(i, j, pixel)
                }
            }
        }

        /** Adds the share of one sample to the pixel. */
        private fun add(
            i: Int,
            j: Int,
            pixel: Int,
        ) {
            val number = visibility.surface(i, j)
            if (number == ReferencePicture.NO_SURFACE) return
            shader.shade(number, visibility.windowX(i), visibility.windowY(j), point)
            picture.rgb[3 * pixel] += point.color.x / (grid * grid)
            picture.rgb[3 * pixel + 1] += point.color.y / (grid * grid)
            picture.rgb[3 * pixel + 2] += point.color.z / (grid * grid)
        }
    }
}

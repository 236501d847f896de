package cga.measure.accuracy.choices

import cga.framework.RenderTarget
import cga.framework.image.FloatImage
import org.lwjgl.opengl.GL33C.glFinish

/** A [Shot] of the scene in the context that is current. Its shaders are read now; it is uploaded when first drawn. */
internal class Drawing(
    private val shot: Shot,
    private val size: PictureSize,
    home: EditedHome,
) : AutoCloseable {
    private val drawn = size.times(shot.grid)
    private val scene = home.with(shot.edits) { scene(drawn).scene }.apply { specularModel = shot.specular }
    private val target by lazy { RenderTarget(drawn.width, drawn.height, shot.samples, shot.format) }

    /** Milliseconds of one frame; with [reads] until the picture is in memory, in its right size. */
    fun time(reads: Boolean): Double {
        val start = System.nanoTime()
        draw()
        if (reads) averaged(target.read().rgba, shot.grid) else glFinish()
        return (System.nanoTime() - start) / 1e6
    }

    fun picture(): FloatImage {
        draw()
        val read = target.readFloats()
        return FloatImage(size.width, size.height, averaged(read.rgba))
    }

    override fun close() {
        scene.cleanup()
        target.close()
    }

    private fun draw() {
        target.bind()
        scene.render()
    }

    /** The mean of grid×grid pixels for each. */
    private fun averaged(rgba: FloatArray): FloatArray {
        if (shot.grid == 1) return rgba
        return FloatArray(4 * size.pixels) { i -> sum(i) { rgba[it] } / (shot.grid * shot.grid) }
    }

    private fun averaged(
        rgba: ByteArray,
        grid: Int,
    ): ByteArray {
        if (grid == 1) return rgba
        return ByteArray(4 * size.pixels) { i -> Math.round(sum(i) { (rgba[it].toInt() and 0xFF).toFloat() } / (grid * grid)).toByte() }
    }

    /** The sum over all that number [i] of the small picture is made of. */
    private inline fun sum(
        i: Int,
        number: (Int) -> Float,
    ): Float {
        val left = i / 4 % size.width * shot.grid
        val top = i / 4 / size.width * shot.grid
        var sum = 0f
        for (y in top until top + shot.grid) for (x in left until left + shot.grid) sum += number(4 * (y * drawn.width + x) + i % 4)
        return sum
    }
}

package cga.inspect.probe

import cga.exercise.game.Scene
import cga.framework.ColorFormat
import cga.framework.Frame
import cga.framework.RenderTarget
import cga.framework.SpecularModel
import cga.inspect.view.Look
import cga.reference.ReferenceRenderer
import cga.reference.ShadedPoint
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack
import java.util.concurrent.Executors
import java.util.concurrent.Future

/**
 * All that is known of one pixel.
 *
 * @param column from the left, [row] from the top, in framebuffer pixels.
 * @param time of the scene, in seconds.
 * @param frame the scene as it was.
 * @param point the reference's numbers; null where the pixel shows nothing.
 * @param expected the colour that the reference gives the pixel in this view.
 * @param drawn the colour that the GPU computed at the pixel's centre, unclamped, RGBA32F.
 * @param shown what the window's framebuffer held there, 0..255; with several samples a pixel their mean.
 */
internal class Probed(
    val column: Int,
    val row: Int,
    val time: Double,
    val frame: Frame,
    val look: LookedAt,
    val point: ShadedPoint?,
    val expected: Vector3d,
    val drawn: Vector3d,
    val shown: IntArray,
) {
    /** The largest difference between GPU and reference, in steps of 1/255. */
    val difference: Double get() = Vector3d(expected).sub(drawn).absolute().let { maxOf(it.x, it.y, it.z) } * 255
}

/** What was looked at when the pixel was clicked. */
internal class LookedAt(
    val view: String,
    val light: Int,
)

/** Clicks on pixels. The reference takes some tenths of a second, on a thread of its own. */
internal class Probe(private val scene: Scene) : AutoCloseable {
    private val reference = Executors.newSingleThreadExecutor { task -> Thread(task, "probe").apply { isDaemon = true } }

    /**
     * The pixel ([column], [row]) from the upper left of a picture of [width]×[height], drawn with [look]; its specular model is [model].
     * The window's framebuffer must still hold the picture. Needs the OpenGL context.
     */
    fun look(
        column: Int,
        row: Int,
        width: Int,
        height: Int,
        look: Look,
        model: SpecularModel,
    ): Future<Probed> {
        val shown = shown(column, height - 1 - row)
        val drawn = drawn(column, height - 1 - row, width, height)
        val frame = frame(model)
        val time = scene.time
        val asked = look.copy()
        return reference.submit<Probed> {
            val point = ReferenceRenderer(frame, width, height).probe(column, row)
            val expected = if (point == null) Vector3d() else Expected.color(point, frame, asked)
            Probed(column, row, time, frame, LookedAt(asked.view.title, asked.light), point, expected, drawn, shown)
        }
    }

    override fun close() {
        reference.shutdownNow()
    }

    private fun frame(model: SpecularModel): Frame {
        val own = scene.specularModel
        scene.specularModel = model
        return scene.frame().also { scene.specularModel = own }
    }

    /** The same picture once more, for this one pixel, without antialiasing and as floats. */
    private fun drawn(
        x: Int,
        y: Int,
        width: Int,
        height: Int,
    ): Vector3d =
        RenderTarget(width, height, 0, ColorFormat.RGBA32F)
            .use { target ->
                target.bind()
                glEnable(GL_SCISSOR_TEST)
                glScissor(x, y, 1, 1)
                scene.render()
                glDisable(GL_SCISSOR_TEST)
                MemoryStack.stackPush().use { stack ->
                    val rgba = stack.mallocFloat(4)
                    glReadPixels(x, y, 1, 1, GL_RGBA, GL_FLOAT, rgba)
                    Vector3d(rgba[0].toDouble(), rgba[1].toDouble(), rgba[2].toDouble())
                }
            }.also { glBindFramebuffer(GL_FRAMEBUFFER, 0) }

    /** From the window itself; by a blit, which averages the samples. */
    private fun shown(
        x: Int,
        y: Int,
    ): IntArray =
        RenderTarget(1, 1)
            .use { target ->
                glBindFramebuffer(GL_READ_FRAMEBUFFER, 0)
                glBlitFramebuffer(x, y, x + 1, y + 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST)
                val rgba = target.read().rgba
                IntArray(3) { rgba[it].toInt() and 0xFF }
            }.also { glBindFramebuffer(GL_FRAMEBUFFER, 0) }
}

package cga.measure.accuracy

import cga.exercise.game.Step
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.context.OffscreenContext
import cga.framework.image.FloatImage
import cga.reference.ReferencePicture
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes

/** What OpenGL makes of a step: the picture, and the number of the triangle that each pixel shows, as [ReferencePicture.surface]. */
internal class GlAgainstTruthShot(
    val picture: FloatImage,
    val surface: IntArray,
) {
    fun write(file: Path) {
        val bytes = ByteBuffer.allocate(4 * (picture.rgba.size + surface.size))
        bytes.asFloatBuffer().put(picture.rgba)
        bytes.position(4 * picture.rgba.size).asIntBuffer().put(surface)
        file.writeBytes(bytes.array())
    }

    companion object {
        fun read(
            file: Path,
            width: Int,
            height: Int,
        ): GlAgainstTruthShot {
            val pixels = width * height
            val bytes = ByteBuffer.wrap(file.readBytes())
            val rgba = FloatArray(4 * pixels).also { bytes.asFloatBuffer().get(it) }
            val surface = IntArray(pixels).also { bytes.position(16 * pixels).asIntBuffer().get(it) }
            return GlAgainstTruthShot(FloatImage(width, height, rgba), surface)
        }

        /** Where in [folder] a shot is kept. */
        fun file(
            folder: Path,
            step: Step,
            view: TruthView,
        ): Path = folder.resolve("${step.name}-${view.name}")
    }
}

/**
 * The process that draws, since Mesa reads from the environment how to filter, once.
 *
 * It takes a shot of every view of each step that is named after the folder in the arguments, says `bits renderer` in a line (the sub-pixel
 * grid has 2^bits steps a pixel), and then answers each line `STEP VIEW column row` with the terms of that pixel, three numbers each.
 */
internal object GlAgainstTruthShooter {
    @JvmStatic
    fun main(args: Array<String>) {
        val folder = Path.of(args[0])
        OffscreenContext.open().use {
            for (step in args.drop(1).map(Step::valueOf)) {
                for (view in TruthView.entries) shoot(step, view).write(GlAgainstTruthShot.file(folder, step, view))
            }
            println("${glGetInteger(GL_SUBPIXEL_BITS)} ${glGetString(GL_RENDERER)}")
            for (line in generateSequence(::readlnOrNull)) {
                val (step, view, column, row) = line.split(' ')
                println(terms(Step.valueOf(step), TruthView.valueOf(view), column.toInt(), row.toInt()).joinToString(" "))
            }
        }
    }

    private fun shoot(
        step: Step,
        view: TruthView,
    ): GlAgainstTruthShot =
        RenderTarget(view.width, view.height, 0, ColorFormat.RGBA32F).use { target ->
            val frame = view.frame(step)
            if (view == TruthView.SCENE) drawScene(step) else GlAgainstTruthTerms(frame, view.lights(step)).use { it.draw(null) }
            val picture = target.readFloats()
            TriangleNumbers.draw(frame)
            val numbers = target.readFloats().rgba
            GlAgainstTruthShot(picture, IntArray(numbers.size / 4) { numbers[4 * it].toInt() })
        }

    private fun drawScene(step: Step) {
        val scene = TruthView.SCENE.scene(step).scene
        scene.render()
        scene.cleanup()
    }

    private fun terms(
        step: Step,
        view: TruthView,
        column: Int,
        row: Int,
    ): List<Float> {
        val frame = view.frame(step)
        return RenderTarget(view.width, view.height, 0, ColorFormat.RGBA32F).use { target ->
            GlAgainstTruthTerms(frame, view.lights(step)).use { terms ->
                GlAgainstTruthTerm.all(frame).flatMap { term ->
                    terms.draw(term)
                    val at = 4 * (row * view.width + column)
                    target.readFloats().rgba.slice(at..at + 2)
                }
            }
        }
    }
}

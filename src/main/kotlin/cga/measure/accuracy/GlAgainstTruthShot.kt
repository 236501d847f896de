package cga.measure.accuracy

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.game.Step
import cga.framework.ColorFormat
import cga.framework.Frame
import cga.framework.RenderTarget
import cga.framework.context.OffscreenContext
import cga.framework.image.FloatImage
import cga.reference.ReferencePicture
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.file.Path
import kotlin.io.path.createTempFile
import kotlin.io.path.deleteIfExists
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

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
            if (view == TruthView.SCENE) drawScene(step) else GlAgainstTruthTerms(frame).use { it.draw(null) }
            val picture = target.readFloats()
            drawNumbers(frame)
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
            GlAgainstTruthTerms(frame).use { terms ->
                GlAgainstTruthTerm.all(frame).flatMap { term ->
                    terms.draw(term)
                    val at = 4 * (row * view.width + column)
                    target.readFloats().rgba.slice(at..at + 2)
                }
            }
        }
    }

    /** Position, texture coordinates, normal: eight floats a vertex. */
    private val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

    /** Draws [frame] with the number of its triangle as the colour of each pixel. */
    private fun drawNumbers(frame: Frame) {
        val program = numbering()
        glClearColor(ReferencePicture.NO_SURFACE.toFloat(), 0f, 0f, 0f)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        program.use()
        program.setUniform("projection", frame.projection, false)
        var first = 0
        for (draw in frame.draws) {
            program.setUniform("modelView", Matrix4f(frame.view.mul(draw.model, Matrix4d())), false)
            program.setUniform("first", first)
            Mesh(draw.vertices, draw.indices, attributes).apply { render() }.cleanup()
            first += draw.indices.size / 3
        }
        program.cleanup()
    }

    private fun numbering(): ShaderProgram {
        val fragment = createTempFile("cga-numbers", ".frag")
        try {
            fragment.writeText(
                "#version 330 core\nuniform int first;\nout vec4 color;\nvoid main() { color = vec4(first + gl_PrimitiveID); }\n",
            )
            return ShaderProgram("shaders/scene.vert", "$fragment")
        } finally {
            fragment.deleteIfExists()
        }
    }
}

package cga.measure.accuracy.choices

import cga.framework.ColorFormat
import cga.framework.InputError
import cga.framework.RenderTarget
import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.framework.image.FloatImage
import cga.measure.accuracy.TriangleNumbers
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.system.exitProcess

/** Frames of one run: the first warms up, the median of the others counts. */
private const val FRAMES = 6

/**
 * Draws and times choices for the process that started this one. First it says what draws; then it answers
 * `time CHOICE` with milliseconds, `draw CHOICE FILE` and `numbers FILE` with `done`, its floats in the file.
 *
 * Arguments: width, height, and the kind of context or nothing.
 */
internal fun main(args: Array<String>) {
    try {
        serve(args)
    } catch (e: InputError) {
        System.err.println("cga: ${e.message}")
        exitProcess(2)
    }
}

private fun serve(args: Array<String>) {
    val size = PictureSize(args[0].toInt(), args[1].toInt())
    OffscreenContext.open(args.getOrNull(2)?.let(ContextKind::valueOf)).use {
        EditedHome().use { home ->
            println("${glGetString(GL_RENDERER)}\t${glGetString(GL_VERSION)}")
            val drawings = Drawings(size, home)
            for (line in generateSequence(::readlnOrNull)) println(drawings.answer(line.split(' ')))
            drawings.close()
        }
    }
}

private class Drawings(
    private val size: PictureSize,
    private val home: EditedHome,
) : AutoCloseable {
    private val timed = HashMap<Int, Drawing>()

    fun answer(words: List<String>): String {
        when (words[0]) {
            "time" -> return time(words[1].toInt()).toString()
            "draw" -> draw(words[1].toInt()).write(Path.of(words[2]))
            "numbers" -> numbers().write(Path.of(words[1]))
            else -> error("no such request: $words")
        }
        return "done"
    }

    override fun close(): Unit = timed.values.forEach(Drawing::close)

    private fun time(number: Int): Double {
        val choice = DrawingChoices.all[number]
        val drawing = timed.getOrPut(number) { Drawing(choice.timed, sizeOf(choice), home) }
        return List(FRAMES) { drawing.time(choice.group.isSmall) }.drop(1).sorted()[(FRAMES - 1) / 2]
    }

    private fun draw(number: Int): FloatImage {
        val choice = DrawingChoices.all[number]
        return Drawing(choice.compared, sizeOf(choice), home).use(Drawing::picture)
    }

    private fun numbers(): FloatImage =
        RenderTarget(size.width, size.height, 0, ColorFormat.RGBA32F).use { target ->
            TriangleNumbers.draw(scene(size).scene.frame())
            target.readFloats()
        }

    private fun sizeOf(choice: DrawingChoice) = if (choice.group.isSmall) size.small else size
}

private fun FloatImage.write(file: Path) {
    file.writeBytes(ByteBuffer.allocate(4 * rgba.size).also { it.asFloatBuffer().put(rgba) }.array())
}

/** The floats that a worker put into a file. */
internal fun readFloats(file: Path): FloatArray {
    val floats = ByteBuffer.wrap(file.readBytes()).asFloatBuffer()
    return FloatArray(floats.remaining()).also { floats.get(it) }
}

package cga.cli.window

import cga.cli.OpenGLCanvas
import cga.cli.contextOption
import cga.cli.numbered
import cga.cli.requireEnding
import cga.cli.requireUsage
import cga.cli.sizeOption
import cga.framework.AtomicFile
import cga.framework.ColorFormat
import cga.framework.image.ApngFile
import cga.framework.image.ImageData
import cga.framework.image.PngFile
import cga.inspect.record.Recording
import cga.inspect.record.Replay
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path

/** `cga replay`: the pictures of a recording, off screen. */
internal class ReplayCommand : CliktCommand("replay") {
    override fun help(context: Context): String =
        "Play the input that F9 in the window saved once more, off screen: as an animated picture, a sequence, or the very screenshots."

    private val recording by argument(help = "The file that F9 saved").path()
    private val out by option(
        "--out",
        metavar = "FILE",
        help = "FILE.apng for an animation, FILE.png for FILE-0001.png, … Default: replay.apng",
    ).path()
        .default(Path.of("replay.apng"))
    private val pictures by option("--pictures", help = "Only the pictures that F12 saved, the same to the last bit").flag()
    private val fps by option("--fps", metavar = "F", help = "Pictures a second. Default: 30").double().default(30.0)
    private val size by sizeOption()
    private val samples by option("--samples", metavar = "N", help = "Samples a pixel. Default: 4, as in the window").int().default(4)
    private val context by contextOption()

    override fun run() {
        requireUsage(fps.isFinite() && fps in MIN_FPS..Replay.RATE.toDouble()) { "--fps $fps: from $MIN_FPS to ${Replay.RATE}" }
        requireUsage(samples >= 0) { "--samples $samples: must not be negative" }
        requireEnding("--out", out, ".png", ApngFile.SUFFIX)
        AtomicFile.checkWritable(out)
        val recording = Recording.read(recording)
        val updates = if (pictures) recording.pictures else everyPicture(recording.updates)
        requireUsage(updates.size in 1..MAX_FRAMES) {
            "${updates.size} pictures: from 1 to $MAX_FRAMES; choose another --fps, or press F12 while recording"
        }
        val replay = Replay(recording, size.width, size.height)
        OpenGLCanvas(context, size, samples, ColorFormat.RGBA8).use { canvas -> replay.use { play(it, canvas, updates) } }
    }

    /** The updates after which the animation has its pictures. */
    private fun everyPicture(updates: Int) = List((updates * fps / Replay.RATE).toInt() + 1) { (it * Replay.RATE / fps).toInt() }

    private fun play(
        replay: Replay,
        canvas: OpenGLCanvas,
        updates: List<Int>,
    ) {
        fun picture(number: Int): ImageData {
            if (pictures) replay.advanceToPicture() else replay.advanceTo(updates[number])
            canvas.draw(replay::draw)
            return canvas.read()
        }
        if (out.toString().endsWith(ApngFile.SUFFIX)) {
            ApngFile.write(out, updates.size, fps, ::picture)
        } else {
            for (number in updates.indices) PngFile.write(picture(number), numbered(out, number, updates.size))
        }
    }

    private companion object {
        const val MIN_FPS = 1.0
        const val MAX_FRAMES = 9999
    }
}

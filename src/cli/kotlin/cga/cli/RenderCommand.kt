package cga.cli

import cga.exercise.game.DriveScript
import cga.exercise.game.ScriptedScene
import cga.exercise.game.ScriptedScene.Companion.PRETTY_TIME
import cga.exercise.game.Step
import cga.framework.AtomicFile
import cga.framework.ColorFormat
import cga.framework.Phases
import cga.framework.SpecularModel
import cga.framework.image.ApngFile
import cga.framework.image.ExrFile
import cga.framework.image.PngFile
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.float
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionException

/** `cga render`: pictures of the scene without a window. */
public class RenderCommand : CliktCommand("render") {
    override fun help(context: Context): String = "Render a step of the sheet off screen, to PNG or OpenEXR."

    private val step by stepOption()
    private val size by sizeOption()
    private val time by option("--t", metavar = "SECONDS", help = "Time of the picture. Default: the drive script's end, else $PRETTY_TIME")
        .double()
    private val mouse by option("--mouse", metavar = "DX", help = "Move the mouse so many pixels to the right; over all frames together")
        .double()
        .default(0.0)
    private val camera by option("--camera", help = "A view of the motorcycle from near. Default: the sheet's, from behind and above")
        .choice(CameraView.entries.associateBy { it.word })
    private val drive by option("--drive", metavar = "SCRIPT", help = "Keys held from time 0 on, as in \"W 2, WA 0.5\"")
        .convert { DriveScript.parse(it) }
        .default(DriveScript.NONE)
    private val samples by option("--samples", metavar = "N", help = "Samples a pixel. Default: 0, no antialiasing").int().default(0)
    private val specular by option("--specular", help = "Specular model. Default: the step's own")
        .choice("phong" to SpecularModel.PHONG, "blinn-phong" to SpecularModel.BLINN_PHONG)
    private val gamma by option("--gamma", metavar = "G", help = "Encode the colours for a screen of this gamma. Default: 1, none")
        .float()
        .default(1f)
    private val out by option(
        "--out",
        metavar = "FILE.png",
        help = "The picture, or FILE.apng: an animation. Default: motorcycle.png, unless --float is given",
    ).path()
    private val float by option("--float", metavar = "FILE.exr", help = "The unclamped picture as OpenEXR, RGBA32F").path()
    private val renderer by rendererOption()
    private val frames by option("--frames", metavar = "N", help = "Render a sequence FILE-0001.png, FILE-0002.png, …").int().default(1)
    private val fps by option("--fps", metavar = "F", help = "Frames a second of the sequence. Default: 60").double().default(60.0)

    override fun run() {
        checkUsage()
        val png = out ?: if (float == null) Path.of("motorcycle.png") else null
        listOfNotNull(png, float).forEach(AtomicFile::checkWritable)
        // The scene needs no OpenGL to be read, so that happens while the driver starts.
        val reading = CompletableFuture.supplyAsync { Phases.span("scene") { ScriptedScene(size.width, size.height, step, drive) } }
        Phases.span("context") { canvas() }.use { render(reading.result(), it, png) }
    }

    private fun isAnimation(file: Path) = file.toString().endsWith(ApngFile.SUFFIX)

    private fun canvas(): Canvas =
        when (val renderer = renderer) {
            is Renderer.OpenGL -> OpenGLCanvas(renderer.kind, size, samples, if (float == null) ColorFormat.RGBA8 else ColorFormat.RGBA32F)
            Renderer.Reference -> ReferenceCanvas(size, GRIDS.getValue(samples))
        }

    private fun checkUsage() {
        requireUsage(time.let { it == null || (it.isFinite() && it >= 0) }) { "--t $time: the time must be finite and not negative" }
        requireUsage(mouse.isFinite()) { "--mouse $mouse: the way must be finite" }
        requireUsage(gamma.isFinite() && gamma >= MIN_GAMMA) { "--gamma $gamma: gamma must be finite and at least $MIN_GAMMA" }
        requireUsage(frames in 1..MAX_FRAMES) { "--frames $frames: from 1 to $MAX_FRAMES" }
        requireEnding("--out", out, ".png", ApngFile.SUFFIX)
        requireEnding("--float", float, ".exr")
        requireUsage(out?.let(::isAnimation) != true || (float == null && fps in 0.1..655.0)) {
            "--out $out: an animation has no --float beside it, and from 0.1 to 655 pictures a second"
        }
        requireUsage(fps.isFinite() && fps > 0) { "--fps $fps: must be finite and greater than 0" }
        requireUsage((startTime() + (frames - 1) / fps).isFinite()) { "--fps $fps: the last frame's time would be infinite" }
        requireUsage(samples >= 0) { "--samples $samples: must not be negative" }
        requireUsage(renderer != Renderer.Reference || samples in GRIDS) {
            "--samples $samples: the reference takes ${GRIDS.keys.joinToString()} samples a pixel"
        }
        if (mouse != 0.0 && !step.turnsWithMouse) echo("note: --mouse has no effect before step ${Step.ORBIT.sheet}", err = true)
    }

    private fun <T> CompletableFuture<T>.result(): T =
        try {
            join()
        } catch (e: CompletionException) {
            throw e.cause ?: e
        }

    private fun render(
        player: ScriptedScene,
        canvas: Canvas,
        png: Path?,
    ) {
        specular?.let { player.scene.specularModel = it }
        player.scene.gamma = gamma
        camera?.place(player.scene)
        if (frames == 1 && !(png != null && isAnimation(png))) picture(player, canvas, 0, png) else sequence(player, canvas, png)
        player.scene.cleanup()
    }

    private fun sequence(
        player: ScriptedScene,
        canvas: Canvas,
        png: Path?,
    ) {
        if (png != null && isAnimation(png)) {
            return ApngFile.write(png, frames, fps) { frame ->
                draw(player, canvas, frame)
                canvas.read()
            }
        }
        (0 until frames).toList().mapWithProgress(terminal, "rendering") { frame -> picture(player, canvas, frame, png) }
    }

    private fun picture(
        player: ScriptedScene,
        canvas: Canvas,
        frame: Int,
        png: Path?,
    ) {
        draw(player, canvas, frame)
        png?.let { file ->
            val picture = Phases.span("read") { canvas.read() }
            Phases.span("png") { PngFile.write(picture, numbered(file, frame, frames)) }
        }
        float?.let { ExrFile.write(canvas.readFloats(), numbered(it, frame, frames)) }
    }

    private fun draw(
        player: ScriptedScene,
        canvas: Canvas,
        frame: Int,
    ) {
        player.moveMouseTo(if (frames == 1) mouse else mouse * (frame / (frames - 1.0)))
        player.advanceTo(startTime() + frame / fps)
        Phases.span("draw") { canvas.draw(player.scene) }
    }

    /** One clock for everything: a script plays from 0, so its single picture is its end, and its sequence starts at 0. */
    private fun startTime(): Double =
        time ?: when {
            drive.duration == 0.0 -> PRETTY_TIME
            frames == 1 -> drive.duration
            else -> 0.0
        }

    private companion object {
        const val MAX_FRAMES = 9999
        const val MIN_GAMMA = 0.01f

        /** What --samples means to the reference: so many in a row and in a column. */
        val GRIDS = mapOf(0 to 1, 4 to 2, 16 to 4)
    }
}

package cga.grading.analysis

import cga.framework.RenderTarget
import cga.framework.image.ImageData
import cga.framework.image.PngFile
import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.Moment
import cga.grading.capture.UniformValue
import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.replay.Change
import cga.grading.replay.Replay
import cga.grading.scene.ObservedFrame
import java.nio.file.Path

/** The pictures of a report: the whole scene at a few moments, and each light alone. */
internal class ScenePictures(
    private val capture: Capture,
    private val replay: Replay,
    private val folder: Path,
) {
    /** Draws them into the folder. */
    fun take(observed: List<ObservedFrame>): List<Evidence> {
        val last = capture.frames.indexOfLast { it.moment == Moment.TIME_4 }.takeIf { it >= 0 } ?: capture.frames.lastIndex
        val scenes = WHOLE
            .mapNotNull { moment ->
                capture.frames.indexOfFirst { it.moment == moment }.takeIf { it >= 0 }
            }.ifEmpty { listOf(last) }
        return scenes.map(::whole) + lights(last, observed)
    }

    private fun whole(frame: Int): Evidence {
        val name = "scene-${capture.frames[frame].moment.name.lowercase()}.png"
        write(name, frame, WIDTH, HEIGHT, Change.NONE)
        return Evidence(null, "scene at ${"%.1f".format(java.util.Locale.ROOT, capture.frames[frame].time)} s", name, null)
    }

    /** Each light alone: all other colours black, and the emission with them. */
    private fun lights(frame: Int, observed: List<ObservedFrame>): List<Evidence> {
        val names = observed.lastOrNull()?.lights.orEmpty().map { it.name }.distinct()
        return names.take(MOST_LIGHTS).mapIndexed { number, light ->
            val file = "light-$number.png"
            write(file, frame, WIDTH / 2, HEIGHT / 2, Only(light, names.toSet()))
            Evidence(Check.POINT_LIGHT, "light $light", file, null)
        }
    }

    private fun write(name: String, frame: Int, width: Int, height: Int, change: Change) {
        val picture = RenderTarget(width, height, capture.samples).use { target ->
            replay.draw(frame, target, change)
            target.read()
        }
        PngFile.write(ImageData(width, height, opaque(picture.rgba)), folder.resolve(name))
    }

    private fun opaque(rgba: ByteArray): ByteArray = rgba.copyOf().also { for (i in 3 until it.size step 4) it[i] = -1 }

    private class Only(private val light: String, private val lights: Set<String>) : Change() {
        override fun numbers(step: Int, draw: CapturedDraw, uniform: UniformValue): FloatArray =
            if (uniform.name in lights && uniform.name != light) FloatArray(uniform.numbers.size) else uniform.numbers
    }

    private companion object {
        const val WIDTH = 960
        const val HEIGHT = 540
        const val MOST_LIGHTS = 10
        val WHOLE = listOf(Moment.TIME_4, Moment.MOUSE_FAR)
    }
}

package cga.grading.analysis

import cga.framework.Frame
import cga.framework.RenderTarget
import cga.framework.image.ImageData
import cga.framework.image.PngFile
import cga.grading.capture.Capture
import cga.grading.capture.CapturedClear
import cga.grading.capture.CapturedDraw
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Evidence
import cga.grading.findings.Message
import cga.grading.replay.Change
import cga.grading.replay.Replay
import cga.grading.scene.ObservedFrame
import cga.grading.study.Materials
import cga.reference.ReferencePicture
import cga.reference.ReferenceRenderer
import org.lwjgl.opengl.GL33C.GL_COLOR_BUFFER_BIT
import java.nio.file.Path

/**
 * The pictures of a report: the whole scene at a few moments and each light alone, beside what they should be where that is known.
 *
 * @param observed the frames that were understood.
 */
internal class ScenePictures(
    private val capture: Capture,
    private val replay: Replay,
    private val materials: Materials,
    private val expected: ExpectedFrame,
    private val observed: List<ObservedFrame>,
    private val folder: Path,
) {
    /** Draws them into the folder; none where stand-ins take the place of shaders, which would be the grader's pictures. */
    fun take(): List<Evidence> {
        if (capture.frames.any { frame -> frame.draws.any { capture.programs[it.program].substituted } }) return emptyList()
        val last = capture.frames.indexOfLast { it.moment == Moment.TIME_4 }.takeIf { it >= 0 } ?: capture.frames.lastIndex
        val scenes = WHOLE
            .mapNotNull { moment ->
                capture.frames.indexOfFirst { it.moment == moment }.takeIf { it >= 0 }
            }.ifEmpty { listOf(last) }
        // One is enough to compare: the reference takes longer than all the rest.
        return scenes.mapIndexed { number, frame -> whole(frame, isCompared = number == 0) } + lights(last)
    }

    private fun whole(
        frame: Int,
        isCompared: Boolean,
    ): Evidence {
        val moment = capture.frames[frame].moment
        val name = "scene-${moment.name.lowercase()}"
        write("$name.png", frame, SCENE, Change.NONE)
        val truth = if (isCompared) expected("$name-expected.png", frame, SCENE) { expected.whole(capture.frames[frame], it) } else null
        return Evidence(null, Message.of("picture.scene", capture.frames[frame].time), "$name.png", truth)
    }

    /** Each light alone: all other colours black, and the emission with them. */
    private fun lights(frame: Int): List<Evidence> {
        val sent = capture.frames[frame].draws.flatMap { it.uniforms }.map { it.name }.toSet()
        // A colour that is written into the shader cannot be switched off in it.
        val lights = observedAt(frame)?.lights.orEmpty().distinctBy { it.name }.filter { it.name in sent }
        return lights.take(MOST_LIGHTS).mapIndexed { number, light ->
            val name = "light-$number"
            write("$name.png", frame, LIGHT, LightAlone(materials, light.name, lights.map { it.name }.toSet()))
            val truth = expected("$name-expected.png", frame, LIGHT) { expected.light(capture.frames[frame], it, light.name) }
            Evidence(
                if (light.spot ==
                    null
                ) {
                    Check.POINT_LIGHT
                } else {
                    Check.SPOT_LIGHT
                },
                Message.of("picture.light", light.name),
                "$name.png",
                truth,
            )
        }
    }

    private fun observedAt(frame: Int) = observed.find { it.moment == capture.frames[frame].moment }

    private fun write(
        name: String,
        frame: Int,
        size: PictureSize,
        change: Change,
    ) {
        // As the reference counts its samples: a larger picture made smaller, textures and all.
        val picture = RenderTarget(size.grid * size.width, size.grid * size.height).use { target ->
            replay.draw(frame, target, change)
            target.read()
        }
        PngFile.write(size.reduced(picture.rgba), folder.resolve(name))
    }

    /** Has the reference shade what [scene] says and returns the file's [name]; null where it is not known. */
    private fun expected(
        name: String,
        frame: Int,
        size: PictureSize,
        scene: (ObservedFrame) -> Frame?,
    ): String? {
        val truth = observedAt(frame)?.let(scene) ?: return null
        val picture = ReferenceRenderer(truth, size.width, size.height).render(size.grid)
        PngFile.write(ImageData(size.width, size.height, onBackground(picture, frame)), folder.resolve(name))
        return name
    }

    /** The reference's background is black; the submission's own is as good. */
    private fun onBackground(
        picture: ReferencePicture,
        frame: Int,
    ): ByteArray {
        val rgba = picture.toImageData().rgba
        val clears = capture.frames[frame].steps.takeWhile { it !is CapturedDraw }.filterIsInstance<CapturedClear>()
        val color = clears.lastOrNull { it.mask and GL_COLOR_BUFFER_BIT != 0 }?.color ?: return rgba
        for (pixel in picture.surface.indices) {
            if (picture.surface[pixel] != ReferencePicture.NO_SURFACE) continue
            for (c in 0..2) {
                if ((rgba[4 * pixel + c].toInt() and 0xFF) ==
                    0
                ) {
                    rgba[4 * pixel + c] = Math.round(color[c].coerceIn(0f, 1f) * 255).toByte()
                }
            }
        }
        return rgba
    }

    private companion object {
        val SCENE = PictureSize(640, 360, grid = 2)
        val LIGHT = PictureSize(320, 180, grid = 1)
        const val MOST_LIGHTS = 10
        val WHOLE = listOf(Moment.TIME_4, Moment.MOUSE_FAR)
    }
}

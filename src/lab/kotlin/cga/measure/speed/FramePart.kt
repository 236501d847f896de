package cga.measure.speed

import cga.exercise.game.Step
import cga.framework.context.OffscreenContext
import cga.measure.Sample
import cga.measure.accuracy.choices.PictureSize
import cga.measure.twin.RecordedFrame
import cga.measure.twin.Recording
import cga.measure.twin.Twin
import cga.measure.twin.TwinShot
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory

/** The steady frame, ours and the twin's, in turns. */
internal object FramePart {
    private val SIZES = listOf(PictureSize(640, 360), PictureSize(1280, 720), PictureSize(1920, 1080))
    private val SAMPLES = listOf(0, 4)
    private const val FRAMES = 15
    private const val WARM_UP = 60
    private const val MOST_RATIO = 1.03

    fun measure(settings: SpeedSettings): SpeedSection {
        val folder = createTempDirectory("cga-frames")
        try {
            val twin = Twin.compile(folder)
            val recordings = record(settings, folder)
            Speeds(settings).use { ours ->
                val rows = recordings.map { (shot, recording) ->
                    row(settings, shot, ours) { twin.frameTimes(recording, settings.kind, FRAMES, own = true) }
                }
                val alone = List(settings.runs) { ours.withoutDriver(Step.FINAL.sheet, ALONE) }
                return section(rows, Sample(alone.map { median(it.thread) * 1e3 }), Sample(alone.map { median(it.bytes) }))
            }
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    // As many as the JIT compiler wants to see before it does its best.
    private const val ALONE = 4000

    private fun record(
        settings: SpeedSettings,
        folder: Path,
    ): Map<TwinShot, Path> =
        OffscreenContext.open(settings.kind).use {
            SIZES
                .flatMap { size -> SAMPLES.map { TwinShot(Step.FINAL, size.width, size.height, it) } }
                .associateWith { Recording.write(RecordedFrame.of(it), folder.resolve("${it.width}-${it.samples}").createDirectories()) }
        }

    private class Row(
        val shot: TwinShot,
        val ours: Sample,
        val twins: Sample,
        val ratios: Sample,
        val ourThread: Sample,
        val twinsThread: Sample,
        val bytes: Sample,
    )

    private fun row(
        settings: SpeedSettings,
        shot: TwinShot,
        ours: Speeds,
        twin: () -> List<Twin.FrameTime>,
    ): Row {
        val draw = { count: Int -> ours.frame(shot.step.sheet, PictureSize(shot.width, shot.height), shot.samples, count) }
        draw(WARM_UP)
        val rounds =
            List(settings.runs) { round ->
                if (round % 2 == 0) draw(FRAMES).let { it to twin() } else twin().let { draw(FRAMES) to it }
            }
        val clocks = rounds.map { (mine, its) -> median(mine.clock) to median(its.map { it.clock }.toDoubleArray()) }
        return Row(
            shot,
            Sample(clocks.map { it.first }),
            Sample(clocks.map { it.second }),
            Sample(clocks.map { it.first / it.second }),
            Sample(rounds.map { median(it.first.thread) }),
            Sample(rounds.map { (_, its) -> median(its.map { it.thread }.toDoubleArray()) }),
            Sample(rounds.map { median(it.first.bytes) }),
        )
    }

    private fun section(
        rows: List<Row>,
        alone: Sample,
        bytes: Sample,
    ): SpeedSection {
        val frames =
            SpeedTable(
                "The steady frame of step 4.7",
                "Medians of $FRAMES frames each round, ours and the twin's in turns; over the rounds the median (lowest–highest). " +
                    "The twin computes its matrices with GLM. *Thread* is the processor time of the thread that draws, in which Mesa " +
                    "shades vertices and sorts triangles into tiles; the pixels are shaded by threads of Mesa's own.",
                "size, samples",
                listOf("ours, ms", "twin, ms", "ours ÷ twin", "ours, thread ms", "twin, thread ms", "ours, heap bytes"),
                rows.map { SpeedRow(name(it.shot), it.ours, it.twins, it.ratios, it.ourThread, it.twinsThread, it.bytes) },
            )
        val code =
            SpeedTable(
                "Our code without Mesa",
                "The same frame with a driver whose functions do nothing, after thousands of frames: matrices, lights, uniforms and the " +
                    "steps from Java to C.",
                "",
                listOf("thread µs a frame", "heap bytes"),
                listOf(SpeedRow("step 4.7", alone, bytes)),
            )
        val goals = rows.map { Goal("Frame, ${name(it.shot)}", it.ratios.median, MOST_RATIO, "times the twin") }
        return SpeedSection(listOf(frames, code), goals)
    }

    private fun name(shot: TwinShot) = "${shot.width}×${shot.height}, ${if (shot.samples == 0) "no" else "${shot.samples}"} samples"
}

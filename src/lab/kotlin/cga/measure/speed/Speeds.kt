package cga.measure.speed

import cga.measure.accuracy.Worker
import cga.measure.accuracy.choices.PictureSize

/** A process that draws what it is asked for, and says what it took: [SpeedWorker.kt][main]. */
internal class Speeds(settings: SpeedSettings) : AutoCloseable {
    private val worker = Worker("the measuring of speed", "cga.measure.speed.SpeedWorkerKt", listOf(settings.kind.name))
    private val drawn = worker.answer().split('\t')

    /** What draws, as OpenGL names it. */
    val renderer: String get() = drawn[0]
    val version: String get() = drawn[1]

    fun frame(
        step: String,
        size: PictureSize,
        samples: Int,
        count: Int,
    ): FrameTimes = times("frame $step ${size.width} ${size.height} $samples $count")

    fun withoutDriver(
        step: String,
        count: Int,
    ): FrameTimes = times("without-driver $step $count")

    /** How many fragments pass the depth test, and how many pixels they cover. */
    fun fragments(
        step: String,
        size: PictureSize,
    ): Pair<Int, Int> {
        val (passed, covered) = worker.ask("fragments $step ${size.width} ${size.height}").split(' ').map { it.toInt() }
        return passed to covered
    }

    fun submission(
        way: Way,
        objects: Int,
        lights: Int,
        count: Int,
        driver: Boolean = true,
    ): FrameTimes = times("submit${if (driver) "" else "-without-driver"} ${way.name} $objects $lights $count")

    private fun times(request: String): FrameTimes = FrameTimes.parse(worker.ask(request))

    override fun close(): Unit = worker.close()
}

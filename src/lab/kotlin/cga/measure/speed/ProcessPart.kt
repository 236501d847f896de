package cga.measure.speed

import cga.exercise.game.Step
import cga.framework.InputError
import cga.framework.Natives
import cga.framework.context.OffscreenContext
import cga.measure.Sample
import cga.measure.start.Interleaved
import cga.measure.start.PhaseTime
import cga.measure.start.PhaseTimes
import cga.measure.twin.RecordedFrame
import cga.measure.twin.Recording
import cga.measure.twin.Twin
import cga.measure.twin.TwinShot
import org.lwjgl.system.Library
import java.nio.file.Files
import java.nio.file.Path
import java.time.Instant
import java.time.temporal.ChronoUnit.MICROS
import kotlin.io.path.createTempDirectory

/** Loads LWJGL's library and ends: what comes on top of the twin's time whatever a program in the JVM does. */
internal object LwjglStart {
    @JvmStatic
    fun main(args: Array<String>) {
        require(args.isEmpty()) { "it takes no arguments, not ${args.toList()}" }
        // As `cga` itself does.
        System.getProperty("cga.natives")?.let { Natives.keepIn(Path.of(it)) }
        Library.initialize()
    }
}

/** One picture as a whole process, the way CI and graders call it: beside the twin, without each lever, and where the time goes. */
internal object ProcessPart {
    private const val MOST_SECONDS = 0.6
    private const val MOST_RATIO = 2.2
    private const val OURS = "`./cga render`"
    private const val TWIN = "the twin"
    private const val FLOOR = "a JVM that loads LWJGL's library and ends"

    fun measure(settings: SpeedSettings): SpeedSection {
        val folder = createTempDirectory("cga-process")
        try {
            val launcher = LauncherJvm.launcher()
            val render = Render(settings, folder.resolve("ours.png"))
            val commands =
                mapOf(OURS to listOf("$launcher") + render.words) + render.variants() +
                    mapOf(
                        "an empty JVM" to render.java(listOf("-version")),
                        FLOOR to render.java(listOf(LwjglStart::class.java.name)),
                        TWIN to twin(settings, folder),
                    )
            val times = Interleaved.time(commands, settings.runs)
            val memory = mapOf(OURS to peak(commands.getValue(OURS)), TWIN to peak(commands.getValue(TWIN)))
            val processes = commands.keys.map { SpeedRow(it, times.getValue(it).seconds, times.getValue(it).processorSeconds, memory[it]) }
            val phases = List(settings.runs) { render.phases(folder.resolve("phases.txt")) }
            val ours = times.getValue(OURS).seconds.median
            return SpeedSection(
                listOf(processTable(settings, processes), phaseTable(phases)),
                listOf(
                    Goal("One picture to PNG as a process", ours, MOST_SECONDS, "s"),
                    Goal("The same beside the twin", ours / times.getValue(TWIN).seconds.median, MOST_RATIO, "times the twin"),
                ),
                listOf(timeline(phases.minBy { phases -> phases.maxOf { it.end } })),
            )
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    private fun twin(
        settings: SpeedSettings,
        folder: Path,
    ): List<String> {
        val shot = TwinShot(Step.FINAL, settings.size.width, settings.size.height)
        val recording = OffscreenContext.open(settings.kind).use { Recording.write(RecordedFrame.of(shot), folder) }
        return Twin.compile(folder).command(recording, settings.kind, folder.resolve("twin.png"))
    }

    /** The most memory that was resident at any time, MiB; null where /proc does not tell. */
    private fun peak(command: List<String>): Sample? {
        val process = ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
        var mebibytes = 0.0
        while (process.isAlive) {
            mebibytes = maxOf(mebibytes, peakResident(process.pid()))
            Thread.sleep(2)
        }
        return mebibytes.takeIf { it > 0 }?.let { Sample(listOf(it)) }
    }

    private fun peakResident(pid: Long): Double {
        val status = runCatching { Files.readAllLines(Path.of("/proc/$pid/status")) }.getOrDefault(emptyList())
        return status.find { it.startsWith("VmHWM:") }?.filter(Char::isDigit)?.toDouble()?.div(1024) ?: 0.0
    }

    private fun processTable(
        settings: SpeedSettings,
        rows: List<SpeedRow>,
    ) = SpeedTable(
        "One picture as a process",
        "Step 4.7, ${settings.size}, to PNG; all in turns, ${settings.runs} rounds after one that is not counted: the median " +
            "(lowest–highest). *Started directly* is what the launcher ends in, without the shell in front; below it the same without " +
            "one of its levers, and without any. The memory was read once.",
        "",
        listOf("s", "processor s", "resident, MiB"),
        rows,
    )

    private fun phaseTable(phases: List<List<PhaseTime>>): SpeedTable {
        val runs = phases.map(PhaseTimes::byName)
        val names = runs.first().keys
        return SpeedTable(
            "Where the time goes",
            "Spans of the same process, started directly; some hold others, and those of the scene and of the context overlap.",
            "span",
            listOf("ms"),
            names.map { name -> SpeedRow(name, Sample(runs.map { it[name] ?: 0.0 })) },
        )
    }

    private fun timeline(phases: List<PhaseTime>) =
        TimelinePicture(
            "performance-process",
            "Where the time of one picture goes",
            phases.sortedBy { it.start }.map {
                it.name to
                    it.start..it.end
            },
        )

    /** The process that the launcher starts, and its variants: its options are this process' own. */
    private class Render(
        settings: SpeedSettings,
        picture: Path,
    ) {
        val words = listOf("render", "--step", Step.FINAL.sheet, "--size", "${settings.size}".replace('×', 'x'), "--out", "$picture")
        private val jvm = LauncherJvm.ofThisProcess()

        fun java(words: List<String>) = jvm.command(jvm.levers, words)

        fun variants(): Map<String, List<String>> =
            mapOf("… started directly" to start(jvm.levers)) +
                jvm.levers.map { lever -> "… without ${lever.name}" to start(jvm.levers - lever) } +
                mapOf("… without all of these" to start(emptyList()))

        private fun start(levers: List<Lever>) = jvm.command(levers, listOf("cga.cli.MainKt") + words)

        /** From the start of the process to its end. */
        fun phases(file: Path): List<PhaseTime> {
            val started = now()
            val command = jvm.command(jvm.levers, listOf("-Dcga.phases=$file", "cga.cli.MainKt") + words)
            val process = ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
            if (process.waitFor() != 0) throw InputError("${command.joinToString(" ")} failed with exit code ${process.exitValue()}.")
            val end = (now() - started) / 1e3
            val phases = PhaseTimes.read(file, started)
            val main = phases.single { it.name == "main" }
            return listOf(PhaseTime("JVM-start", 0.0, main.start)) + phases + PhaseTime("exit", main.end, end)
        }

        private fun now(): Long = MICROS.between(Instant.EPOCH, Instant.now())
    }
}

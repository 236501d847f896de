package cga.measure

import cga.exercise.game.Step
import cga.framework.Home
import cga.framework.InputError
import java.nio.file.Files
import java.nio.file.Path

/** One picture as a whole process, the way CI and graders call it. */
public object ProcessBench {
    /** @param seconds from start to exit; @param mebibytes the most memory that was resident (0 where /proc does not tell). */
    public class Result(
        public val seconds: Sample,
        public val mebibytes: Sample,
    )

    /** Runs `./cga render` [runs] times, after one run that is not counted. */
    public fun measure(
        runs: Int,
        step: Step,
        width: Int,
        height: Int,
    ): Result {
        val launcher = Home.resolve("cga")
        if (!Files.isExecutable(launcher)) throw InputError("the launcher $launcher is not there: start this through ./cga bench.")
        val picture = Files.createTempFile("cga-bench", ".png")
        try {
            val options = listOf("--step", step.sheet, "--size", "${width}x$height", "--out", picture.toString())
            val command = listOf(launcher.toString(), "render") + options
            run(command)
            val results = List(runs) { run(command) }
            return Result(Sample(results.map { it.first }), Sample(results.map { it.second }))
        } finally {
            Files.deleteIfExists(picture)
        }
    }

    private fun run(command: List<String>): Pair<Double, Double> {
        val start = System.nanoTime()
        val process = ProcessBuilder(command).inheritIO().start()
        var resident = 0.0
        while (process.isAlive) {
            resident = maxOf(resident, peakResident(process.pid()))
            Thread.sleep(5)
        }
        val seconds = (System.nanoTime() - start) / 1e9
        if (process.exitValue() != 0) throw InputError("${command.joinToString(" ")} failed with exit code ${process.exitValue()}.")
        return seconds to resident
    }

    private fun peakResident(pid: Long): Double {
        val status = runCatching { Files.readAllLines(Path.of("/proc/$pid/status")) }.getOrDefault(emptyList())
        val line = status.find { it.startsWith("VmHWM:") } ?: return 0.0
        return line.filter(Char::isDigit).toDouble() / 1024
    }
}

package cga.measure.start

import cga.framework.InputError
import cga.measure.Sample

/** What whole processes took. @param seconds by the clock; @param processorSeconds of all processors together, user and system. */
internal class ProcessTimes(
    val seconds: Sample,
    val processorSeconds: Sample,
)

/**
 * Times commands against each other on a machine that does other things too: a round runs each once, every second one in the opposite
 * order, so that what slows the machine for a while slows all of them.
 *
 * Processor time is the shell's `times`, so this wants a POSIX shell.
 */
internal object Interleaved {
    /** Times each of [commands] (name to words) [rounds] times, after a round that is not counted. Throws [InputError] when one fails. */
    fun time(
        commands: Map<String, List<String>>,
        rounds: Int,
        environment: Map<String, String> = emptyMap(),
    ): Map<String, ProcessTimes> {
        val runs = commands.mapValues { ArrayList<Run>() }
        for (round in 0..rounds) {
            val order = if (round % 2 == 0) commands.entries.toList() else commands.entries.reversed()
            for ((name, command) in order) {
                val run = run(command, environment)
                if (round > 0) runs.getValue(name) += run
            }
        }
        return runs.mapValues { (_, times) -> ProcessTimes(Sample(times.map { it.seconds }), Sample(times.map { it.processorSeconds })) }
    }

    private class Run(
        val seconds: Double,
        val processorSeconds: Double,
    )

    // "times" writes a line of the shell's own time and one of its children's.
    private const val SCRIPT = "\"\$@\" >/dev/null 2>&1; status=\$?; LC_ALL=C times; exit \$status"

    private fun run(
        command: List<String>,
        environment: Map<String, String>,
    ): Run {
        val builder = ProcessBuilder(listOf("sh", "-c", SCRIPT, "sh") + command)
        builder.environment() += environment
        val start = System.nanoTime()
        val process = builder.start()
        val says = process.inputReader().readText()
        val status = process.waitFor()
        val seconds = (System.nanoTime() - start) / 1e9
        if (status != 0) throw InputError("${command.joinToString(" ")} failed with exit code $status.")
        return Run(seconds, processorSeconds(says))
    }

    /** The sum of the children's times, as in "0m0.120000s 0m0.030000s". */
    internal fun processorSeconds(times: String): Double =
        times.trim().lines().last().split(' ').sumOf { time ->
            val (minutes, seconds) = time.removeSuffix("s").split('m')
            60 * minutes.toDouble() + seconds.toDouble()
        }
}

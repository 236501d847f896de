package cga.cli

import cga.measure.FrameBench
import cga.measure.ProcessBench
import cga.measure.Sample
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo
import com.github.ajalt.mordant.table.table

/** `cga bench`: the figures of the README. */
internal class BenchCommand : CliktCommand("bench") {
    override fun help(context: Context): String = "Measure one picture as a process, and the steady frame: time, memory, allocation."

    private val runs by option("--runs", metavar = "N", help = "Processes to measure. Default: 9").int().restrictTo(min = 1).default(9)
    private val frames by option("--frames", metavar = "N", help = "Frames to measure. Default: 200").int().restrictTo(min = 1).default(200)
    private val step by stepOption()
    private val size by sizeOption()
    private val context by contextOption()

    override fun run() {
        val process = ProcessBench.measure(runs, step, size.width, size.height)
        val frame = FrameBench.measure(context, frames, step, size.width, size.height)
        terminal.println(
            table {
                header { row("figure", "median", "lowest", "highest") }
                body {
                    row("cga render as a process, s", *process.seconds.columns("%.2f"))
                    row("  resident memory, MiB", *process.mebibytes.columns("%.0f"))
                    row("steady frame, ms", *frame.milliseconds.columns("%.1f"))
                    row("  allocated by the JVM, bytes", *frame.bytes.columns("%.0f"))
                }
            },
        )
        val processors = Runtime.getRuntime().availableProcessors()
        echo("${size.width}x${size.height}, step ${step.sheet}, ${frame.renderer}, $processors processors")
    }

    private fun Sample.columns(format: String) = arrayOf(median, lowest, highest).map { format.format(it) }.toTypedArray()
}

package cga.cli.lab

import cga.cli.contextOption
import cga.cli.sizeOption
import cga.framework.Home
import cga.measure.speed.SpeedReport
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.path
import com.github.ajalt.clikt.parameters.types.restrictTo

/** `cga bench`: the figures and pictures of docs/performance.md. */
internal class BenchCommand : CliktCommand("bench") {
    override fun help(context: Context): String =
        "Measure where the time goes, beside a C++ twin of the program, and write tables, pictures and JSON into a document."

    private val runs by option(
        "--runs",
        metavar = "N",
        help = "Rounds of everything that is timed. Default: 9",
    ).int().restrictTo(min = 1).default(9)
    private val only by option("--only", help = "Measure this part, and leave the others as they are; may be repeated")
        .choice(*SpeedReport.parts.toTypedArray())
        .multiple()
    private val out by option("--out", metavar = "FILE.md", help = "The document, with its markers. Default: docs/performance.md").path()
    private val size by sizeOption()
    private val context by contextOption()

    override fun run() {
        val file = out ?: Home.resolve("docs/performance.md")
        SpeedReport(file).write(only.ifEmpty { SpeedReport.parts }, runs, size.width, size.height, context) { echo("$it…", err = true) }
        echo("wrote $file")
    }
}

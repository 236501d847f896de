package cga.cli.lab

import cga.cli.contextOption
import cga.cli.sizeOption
import cga.framework.Home
import cga.framework.InputError
import cga.measure.MarkedDocument
import cga.measure.accuracy.choices.AccuracySettings
import cga.measure.accuracy.choices.AccuracyTables
import cga.measure.accuracy.choices.Measurement
import cga.measure.accuracy.choices.PictureSize
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.path
import com.github.ajalt.clikt.parameters.types.restrictTo
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.createDirectories

/** `cga accuracy`: the figures and plots of docs/accuracy.md. */
internal class AccuracyCommand : CliktCommand("accuracy") {
    override fun help(context: Context): String =
        "Measure speed against error for every choice a reader could make, and write the tables and plots into a document."

    private val runs by option(
        "--runs",
        metavar = "N",
        help = "Runs of everything that is timed. Default: 7",
    ).int().restrictTo(min = 1).default(7)
    private val size by sizeOption()
    private val out by option("--out", metavar = "FILE.md", help = "The document, with its markers. Default: docs/accuracy.md").path()
    private val only by option("--only", help = "Measure this part alone, and leave the others as they are").choice(AccuracyTables.all)
    private val context by contextOption()

    override fun run() {
        val file = out ?: Home.resolve("docs/accuracy.md")
        val parts = only?.let(::listOf) ?: AccuracyTables.all.values.toList()
        // Measuring takes minutes: a document that cannot take the result is found out before.
        val document = MarkedDocument.read(file)
        parts.flatMap { it.markers }.forEach(document::require)
        val settings = AccuracySettings(runs, PictureSize(size.width, size.height), context) { echo("$it…", err = true) }
        val measurements = parts.map { it.measure(settings) }
        writePlots(measurements, images(file))
        measurements
            .flatMap { it.contents.entries }
            .fold(document) { filled, (marker, content) -> filled.with(marker, content) }
            .write()
        echo("wrote $file")
    }

    private fun writePlots(
        measurements: List<Measurement>,
        folder: Path,
    ) {
        val plots = measurements.flatMap { it.plots }
        if (plots.isEmpty()) return
        try {
            folder.createDirectories()
        } catch (e: IOException) {
            throw InputError("cannot make the folder $folder for the plots: name a document elsewhere.", e)
        }
        plots.forEach { it.write(folder) }
    }

    /** Where the document's links point. */
    private fun images(document: Path): Path = document.toAbsolutePath().resolveSibling("images")
}

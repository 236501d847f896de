package cga.cli.lab

import cga.cli.mapWithProgress
import cga.framework.AtomicFile
import cga.framework.Home
import cga.framework.context.OffscreenContext
import cga.imaging.golden.GoldenStore
import cga.imaging.tolerance.Tolerance
import cga.measure.MarkedDocument
import cga.measure.golden.GoldenCases
import cga.measure.golden.GoldenRun
import cga.measure.mutation.MutantRun
import cga.measure.mutation.Mutants
import cga.measure.mutation.MutationReport
import cga.measure.mutation.Renderer
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import kotlin.io.path.writeText

/** `cga golden mutants`: which defects the compare finds, and whether it lets sound renderers pass. */
internal class GoldenMutantsCommand : CliktCommand("mutants") {
    override fun help(context: Context): String =
        "Render the golden cases with deliberate defects, and on other renderers, and tabulate what the compare says. Takes minutes."

    private val only by option("--only", metavar = "TEXT", help = "Only defects and renderers with TEXT in their name").default("")
    private val tier by option("--tier", metavar = "NAME", help = "The tolerant tier to try. Default: $TOLERANT").default(TOLERANT)
    private val mesa by option(
        "--mesa",
        metavar = "FOLDER",
        help = "Libraries of another Mesa, to render with as well",
    ).path(mustExist = true)
    private val figures by option("--figures", metavar = "FILE.csv", help = "Write the figures of every case").path()
    private val doc by option(
        "--doc",
        metavar = "FILE.md",
        help = "Put the table between the file's markers, instead of printing it",
    ).path()

    override fun run() {
        figures?.let(AtomicFile::checkWritable)
        val page = doc?.let(MarkedDocument::read)?.also { it.require(MARKER) }
        val report = OffscreenContext.open().use { measure() }
        figures?.let { file -> AtomicFile.write(file) { it.writeText(report.csv()) } }
        if (page == null) echo(report.markdown()) else page.with(MARKER, report.markdown()).write()
        for (failure in report.failures) echo(failure, err = true)
        if (report.failures.isNotEmpty()) throw ProgramResult(1)
    }

    private fun measure(): MutationReport {
        val cases = GoldenCases.all
        val tolerance = Tolerance.read(Home.resolve("${GoldenRun.FOLDER}/${GoldenStore.TOLERANCE}"), tier)
        val run = MutantRun(Mutants.ALL.filter { only in it.name }, cases, tolerance)
        val renderers = Renderer.all(mesa?.toAbsolutePath()).filter { only in it.title }
        val mutants = run.results(cases.mapWithProgress(terminal, "defects", run::figures))
        return MutationReport(mutants, renderers.mapWithProgress(terminal, "renderers", run::result), cases.size)
    }

    private companion object {
        const val TOLERANT = "llvmpipe"
        const val MARKER = "table:mutants"
    }
}

package cga.cli

import cga.framework.AtomicFile
import cga.framework.Home
import cga.framework.InputError
import cga.framework.context.OffscreenContext
import cga.imaging.golden.GoldenStore
import cga.imaging.tolerance.Tolerance
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
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
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
        val page = doc?.let(::Page)
        val report = OffscreenContext.open().use { measure() }
        figures?.let { file -> AtomicFile.write(file) { it.writeText(report.csv()) } }
        if (page == null) echo(report.markdown()) else page.write(report.markdown())
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

    /** A file with a place for the table; looked at before the work, and read again after it. */
    private class Page(private val file: Path) {
        init {
            if (!Files.isRegularFile(file)) throw InputError("--doc $file is not a file: name the page to put the table in.")
            place(file.readText())
        }

        fun write(table: String) {
            val text = file.readText()
            val page = text.replaceRange(place(text), table)
            AtomicFile.write(file) { it.writeText(page) }
        }

        private fun place(text: String): IntRange {
            val begin = text.indexOf(BEGIN) + BEGIN.length
            val end = text.indexOf(END)
            if (begin < BEGIN.length ||
                end < begin
            ) {
                throw InputError("--doc $file must hold the line ${BEGIN.trim()} and later $END: add them.")
            }
            return begin until end
        }
    }

    private companion object {
        const val TOLERANT = "llvmpipe"
        const val BEGIN = "<!-- mutants: begin -->\n"
        const val END = "<!-- mutants: end -->"
    }
}

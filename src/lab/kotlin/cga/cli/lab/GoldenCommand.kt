package cga.cli.lab

import cga.cli.contextOption
import cga.cli.mapWithProgress
import cga.cli.requireUsage
import cga.exercise.components.shader.UniformNames
import cga.framework.AtomicFile
import cga.imaging.Comparison
import cga.imaging.Severity
import cga.imaging.brief
import cga.imaging.golden.Outcome
import cga.imaging.percent
import cga.imaging.report.HtmlReport
import cga.imaging.step
import cga.measure.golden.GoldenCase
import cga.measure.golden.GoldenCases
import cga.measure.golden.GoldenRenderer
import cga.measure.golden.GoldenResult
import cga.measure.golden.GoldenRun
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.core.subcommands
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.path
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.table

/** Something is not as it was approved. */
private const val EXIT_DIFFERENT = 1

/** `cga golden`: the pictures of now against those that were approved. */
internal class GoldenCommand : CliktCommand("golden") {
    override fun help(context: Context): String =
        "Render the golden cases and compare them with the approved images. Exit code 1: a case failed."

    override val invokeWithoutSubcommand = true

    private val only by option("--only", metavar = "PATTERN", help = "Only cases of this name; * stands for anything, as in 'orbit-*'")
    private val report by option("--report", metavar = "FILE.html", help = "Write a page that shows every case").path()
    private val context by contextOption()

    init {
        subcommands(GoldenAcceptCommand(), GoldenMutantsCommand())
    }

    override fun run() {
        if (currentContext.invokedSubcommand != null) return
        report?.let(AtomicFile::checkWritable)
        val run = GoldenRun(GoldenRenderer(context))
        val isWanted = matcher(only ?: "*")
        val strays = run.strays().filter { isWanted(it.name) }
        val cases = GoldenCases.all.filter { isWanted(it.name) }
        if (cases.isEmpty() &&
            strays.isEmpty()
        ) {
            throw UsageError("--only $only: no case has such a name: did you mean ${nearest(only.orEmpty())}?")
        }
        val results = cases.mapWithProgress(terminal, "rendering", run::result) + strays
        terminal.println(overview(results))
        for (result in results) for (message in result.outcome.messages) echo("${result.name}: $message")
        echo(summary(results))
        report?.let { HtmlReport.write("Golden images", results.map(GoldenResult::reportCase), it) }
        if (results.any { it.outcome.severity == Severity.FAIL }) throw ProgramResult(EXIT_DIFFERENT)
    }

    private fun overview(results: List<GoldenResult>) =
        table {
            cellBorders = Borders.LEFT_RIGHT
            header { row("case", "verdict", *FIGURES) }
            body { for (result in results) row(result.name, verdict(result.outcome), *figures(result.outcome.comparison)) }
        }

    /** "29 pass, 1 warn, 2 fail". */
    private fun summary(results: List<GoldenResult>): String =
        results.groupingBy { verdict(it.outcome) }.eachCount().entries.joinToString { "${it.value} ${it.key}" }

    private fun matcher(pattern: String): (String) -> Boolean {
        val regex = Regex(pattern.split('*').joinToString(".*") { Regex.escape(it) })
        return regex::matches
    }
}

/** `cga golden accept`: what was looked at and found right becomes the golden. */
internal class GoldenAcceptCommand : CliktCommand("accept") {
    override fun help(context: Context): String =
        "Approve the present picture of cases, after looking at it (./cga golden --report FILE.html shows it)."

    private val cases by argument("CASE", help = "Cases to approve").multiple()
    private val all by option("--all", help = "Approve every case whose picture or inputs changed").flag()
    private val reason by option("--reason", metavar = "TEXT", help = "Why the picture is right; goes into the sidecar").required()
    private val also by option("--also", help = "Keep the approved images there are, and add this one").flag()
    private val context by contextOption()

    override fun run() {
        requireUsage(!GoldenRun.isCi()) { "golden accept: not in CI (the variable CI is set): approving is for people who look" }
        requireUsage(reason.isNotBlank()) { "--reason: say why the picture is right" }
        requireUsage(all != cases.isNotEmpty()) { "name cases, or give --all: one of the two" }
        val chosen = if (all) GoldenCases.all else cases.map(::case).distinct()
        val run = GoldenRun(GoldenRenderer(context))
        val results = chosen.mapWithProgress(terminal, "rendering", run::result)
        terminal.println(
            table {
                cellBorders = Borders.LEFT_RIGHT
                header { row("case", "before", *FIGURES) }
                body { for (result in results) row(result.name, verdict(result.outcome), *figures(result.outcome.comparison)) }
            },
        )
        for (result in results) echo("${result.name}: ${accept(run, result)}")
        if (results.any { it.rendered == null }) throw ProgramResult(EXIT_DIFFERENT)
    }

    private fun case(name: String): GoldenCase =
        GoldenCases.all.find { it.name == name } ?: throw UsageError("$name is no case: did you mean ${nearest(name)}?")

    private fun accept(
        run: GoldenRun,
        result: GoldenResult,
    ): String {
        val rendered = result.rendered ?: return "not approved: ${result.outcome.messages.first()}"
        if (result.outcome.severity == Severity.PASS && result.outcome.comparison?.isIdentical == true) return "approved already"
        // Of the same pixels there need be one image only; its sidecar is brought up to date.
        val further = also && result.outcome.comparison.let { it != null && !it.isIdentical }
        run.store.accept(result.name, rendered, reason.trim(), further)
        return if (further) "approved as well" else "approved"
    }
}

private val FIGURES = arrayOf("max", "differing", "window", "ꟻLIP mean")

/** The columns of [FIGURES]; what is equal has no figures, and of what was not compared nothing is known. */
private fun figures(comparison: Comparison?): Array<String> {
    if (comparison == null || comparison.isIdentical) return Array(FIGURES.size) { if (comparison == null) "" else "0" }
    val difference = comparison.difference
    return arrayOf(
        step(difference.maximum.max(), comparison.expected),
        percent(difference.fraction),
        step(comparison.worstWindow(Comparison.WINDOW).error, comparison.expected),
        brief(comparison.flip.mean),
    )
}

private fun verdict(outcome: Outcome) = if (outcome.isSkipped) "skipped" else outcome.severity.name.lowercase()

/** The three names of cases that are most like [name]. */
private fun nearest(name: String) =
    GoldenCases.all.map { it.name }.sortedBy { UniformNames.distance(it, name) }.take(3).joinToString(" or ")

package cga.cli.grader

import cga.cli.requireUsage
import cga.framework.Home
import cga.grading.report.AutograderConfig
import cga.grading.report.AutograderZip
import cga.grading.report.Language
import cga.grading.rubric.Rubric
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.OptionWithValues
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.path
import kotlin.io.path.readBytes

/** `cga gradescope`: the autograder for Gradescope, as the zip that is uploaded there. */
internal class GradescopeCommand : CliktCommand("gradescope") {
    override fun help(context: Context): String =
        "Write autograder.zip for Gradescope. Where its containers have no sandbox, submissions are not run, and their results say so."

    private val folder by argument("DIR", help = "Folder to write autograder.zip into").path()
    private val lang by languageOption()
    private val edition by option("--edition", metavar = "NAME", help = "Edition of the course. Default: detected for each submission")
    private val rubric by option("--rubric", metavar = "FILE.json", help = "Points and tolerances. Default: 100 points of our own").path()
    private val unsafeNoSandbox by option(
        "--unsafe-no-sandbox",
        help = "Where there is no sandbox, run submissions without: they can then write their own results",
    ).flag()

    override fun run() {
        requireUsage(edition?.let { Regex("[A-Za-z0-9._+-]+").matches(it) } ?: true) { "--edition $edition: that is no edition" }
        // One that cannot be used is found now, not by the first student.
        rubric?.let(Rubric::read)
        val bytes = rubric?.readBytes()
        val file = AutograderZip.write(Home.resolve(""), folder, AutograderConfig(lang, edition, bytes, unsafeNoSandbox))
        echo("$file: upload it as the autograder of the assignment, with 2 CPUs and at least 3 GB of memory")
    }
}

/** The language of the reports. */
internal fun ParameterHolder.languageOption(): OptionWithValues<Language, Language, Language> =
    option("--lang", help = "Language of the reports. Default: en")
        .choice(Language.entries.associateBy { it.code })
        .default(Language.ENGLISH)

package cga.cli.grader

import cga.cli.requireUsage
import cga.framework.AtomicFile
import cga.framework.InputError
import cga.grading.course.CourseReport
import cga.grading.course.CourseRun
import cga.grading.course.CourseSettings
import cga.grading.course.GradeOne
import cga.grading.course.Merge
import cga.grading.course.NoSandboxError
import cga.grading.course.ResultStore
import cga.grading.course.Shard
import cga.grading.course.Submission
import cga.grading.findings.FailureReason
import cga.grading.findings.Refused
import cga.grading.report.GradedSubmission
import cga.grading.rubric.Rubric
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.path
import com.github.ajalt.clikt.parameters.types.restrictTo
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile

/** What `cga grade` asks of whoever grades one submission. */
internal class PipelineSettings(
    val edition: String?,
    val unsafeNoSandbox: Boolean,
    val jobs: Int,
    val sharesCompiler: Boolean,
)

/**
 * `cga grade`: many submissions, from the command line to the reports.
 *
 * @param pipeline makes what grades one submission; it throws [NoSandboxError] where that would have to run without a sandbox.
 */
internal class GradeCommand(
    private val pipeline: (PipelineSettings) -> GradeOne,
) : CliktCommand("grade") {
    constructor() : this(::gradeOne)

    override fun help(context: Context): String =
        "Grade submissions off screen: points per task, the mistakes by name, a page for each and a contact sheet over all. " +
            "Exit code 1: some could not be graded, by no fault of their own."

    private val submissions by argument("SUBMISSION", help = "Folders or archives to grade; with --merge, result folders")
        .path(mustExist = true)
        .multiple(required = true)
    private val out by option("--out", metavar = "DIR", help = "Folder for the results").path().required()
    private val edition by option("--edition", metavar = "NAME", help = "Edition of the course. Default: detected for each submission")
    private val rubric by option("--rubric", metavar = "FILE.json", help = "Points and tolerances. Default: 100 points of our own").path()
    private val jobs by option("--jobs", metavar = "N", help = "Submissions at the same time. Default: half of the processors")
        .int()
        .restrictTo(1..256)
        .default(maxOf(1, Runtime.getRuntime().availableProcessors() / 2))
    private val shard by option("--shard", metavar = "I/N", help = "Grade only part I of N, to share a course among machines")
        .convert { Shard.of(it) }
        .default(Shard.WHOLE)
    private val resume by option("--resume", help = "Go on with the results in --out: what is done is not done again").flag()
    private val merge by option("--merge", help = "Put the results of shards together in --out").flag()
    private val lang by languageOption()
    private val gradescope by option(
        "--gradescope",
        metavar = "FILE.json",
        help = "Write the results of the one submission here, as Gradescope reads them, after every check",
    ).path()
    private val unsafeNoSandbox by option(
        "--unsafe-no-sandbox",
        help = "Run submissions without a sandbox: they can do whatever you can. Only for submissions that you trust",
    ).flag()

    private val separateCompilers by option(
        "--separate-compilers",
        help = "Compile each submission in a process of its own, rather than one after another in one: slower",
    ).flag()

    override fun run() {
        checkUsage()
        gradescope?.let(AtomicFile::checkWritable)
        val settings = CourseSettings(rubric?.let(Rubric::read) ?: Rubric.default(), lang, edition, jobs, gradescope)
        val grader = if (merge) null else grader()
        if (unsafeNoSandbox && !merge) echo(UNCONFINED, err = true)
        val (graded, missing) =
            ResultStore.open(out, resume).use { store ->
                val (graded, missing) = if (grader == null) merged(store, settings) else graded(store, settings, grader) to emptyList()
                CourseReport.write(out, graded, missing, lang)
                graded to missing
            }
        summarize(graded, missing)
        // One of many that is none is its student's affair; the only one is a mistake of whoever typed it.
        graded.singleOrNull()?.refusal?.takeIf { it.reason == FailureReason.NOT_RECOGNIZED && gradescope == null && !merge }?.let {
            throw InputError(it.detail)
        }
        if (missing.isNotEmpty() || graded.any { it.points == null }) throw ProgramResult(INCOMPLETE)
    }

    private fun checkUsage() {
        if ("$out".isEmpty()) throw InputError("--out is empty: name a folder.")
        for (submission in submissions) {
            if ("$submission".isEmpty()) throw InputError("the name of a submission is empty: name its folder or its archive.")
            if (!submission.isDirectory() && !submission.isRegularFile()) {
                throw InputError("$submission is neither a folder nor a file: name the folder or the archive of a submission.")
            }
        }
        requireUsage(!merge || shard.count == 1) { "--merge puts shards together: leave --shard away" }
        requireUsage(!merge || gradescope == null) { "--gradescope is for one submission: leave --merge away" }
        requireUsage(gradescope == null || submissions.size == 1) { "--gradescope is for one submission, not ${submissions.size}" }
    }

    private fun grader(): GradeOne =
        try {
            // The first one is not compiled any faster.
            pipeline(PipelineSettings(edition, unsafeNoSandbox, jobs, sharesCompiler = !separateCompilers && submissions.size > jobs))
        } catch (e: NoSandboxError) {
            // Gradescope shows its results or nothing; everyone else is told at once.
            if (gradescope == null) throw e
            GradeOne { _, _, _ -> Refused(FailureReason.NO_SANDBOX, e.message.orEmpty()) }
        }

    private fun graded(store: ResultStore, settings: CourseSettings, grader: GradeOne): List<GradedSubmission> {
        val chosen = Submission.of(submissions).filter { it in shard }
        return CourseProgress(terminal, chosen.size, jobs).use { progress ->
            val run = CourseRun(store, grader, settings, progress)
            if (resume) progress.resuming(run.interrupted)
            grader.use { run.run(chosen, shard) }
        }
    }

    private fun merged(store: ResultStore, settings: CourseSettings): Pair<List<GradedSubmission>, List<String>> =
        CourseProgress(terminal, total = 0, jobs).use { progress ->
            val merged = Merge(store, settings, progress).run(submissions)
            merged.warnings.forEach(progress::problem)
            merged.submissions to merged.missing
        }

    private fun summarize(graded: List<GradedSubmission>, missing: List<String>) {
        val refused = graded.mapNotNull { it.refusal }
        val parts =
            listOf("${graded.size - refused.size} graded", "${refused.size} refused", "${missing.size} without a result")
                .filter { !it.startsWith("0 ") || it == "0 graded" }
        echo("${parts.joinToString()}: ${out.resolve("index.html")}")
        for ((reason, count) in refused.groupingBy { it.reason }.eachCount()) echo("  $count ${reason.id}")
    }

    private companion object {
        const val INCOMPLETE = 1
        const val UNCONFINED =
            "warning: --unsafe-no-sandbox: submissions run with all your rights and can change results, their own and others'."
    }
}

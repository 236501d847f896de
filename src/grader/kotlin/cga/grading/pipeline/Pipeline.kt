package cga.grading.pipeline

import cga.framework.InputError
import cga.grading.compile.CompileResult
import cga.grading.compile.CompilerCache
import cga.grading.compile.LibraryUnavailable
import cga.grading.compile.Repair
import cga.grading.compile.SubmissionCompiler
import cga.grading.course.CheckListener
import cga.grading.course.GradeOne
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import cga.grading.findings.Outcome
import cga.grading.sandbox.Sandbox
import cga.grading.sandbox.Scratch
import cga.grading.submission.Edition
import cga.grading.submission.NotASubmission
import cga.grading.submission.SourceFile
import cga.grading.submission.Submission
import cga.grading.submission.SubmissionReader
import java.nio.file.Path
import kotlin.io.path.createDirectories

/**
 * From a folder or an archive to what was measured of it: unpack, compile, run, measure. Each step that touches what a student wrote is a
 * process of its own in [sandbox]; a step that fails ends it with the reason.
 *
 * @param edition the sheet's, null where each submission's is detected.
 * @param home where the compilers and the worker are kept between runs.
 * @param limits of each step.
 * @param sharesCompiler whether submissions that compile are compiled in one process after another, rather than each in its own.
 */
public class Pipeline(
    private val sandbox: Sandbox,
    private val edition: Edition?,
    home: Path,
    private val limits: PipelineLimits = PipelineLimits(),
    sharesCompiler: Boolean = false,
) : GradeOne {
    private val programs = Programs(home)
    private val compiler =
        SubmissionCompiler(sandbox, CompilerCache(home), programs.forSubmissions, limits.compile, programs.own.takeIf { sharesCompiler })

    override fun grade(submission: Path, folder: Path, listener: CheckListener): Outcome {
        val work = folder.toRealPath().resolve("work").createDirectories()
        val run = Run()
        return try {
            grade(submission, folder, work, run).also { if (it is Graded) it.findings.checks.forEach(listener::measured) }
        } catch (e: Stopped) {
            run.refused(e.reason, e.detail)
        } finally {
            Scratch.delete(work)
        }
    }

    override fun close(): Unit = compiler.close()

    private fun grade(given: Path, folder: Path, work: Path, run: Run): Outcome {
        val submission = run.timed("unpack") { read(given, work) }
        run.kind = submission.kind.name.lowercase()
        run.edition = submission.edition.edition.title
        val main = submission.mainClass ?: throw Stopped(FailureReason.NOT_RECOGNIZED, "There is no main function to start.")
        val compiled = run.timed("compile") { compile(submission, work.resolve("compile").createDirectories(), run) }
        val start = RunFolder(submission, work.resolve("assets"))
        val capture = run.timed("run") {
            val scratch = work.resolve("run").createDirectories()
            CaptureStep(sandbox, programs, limits.run).capture(submission, start.folder, main, compiled, scratch, run)
        }
        return run
            .timed("measure") {
                MeasureStep(
                    sandbox,
                    programs,
                    limits.measure,
                ).measure(submission, capture, work.resolve("measure").createDirectories(), folder, run)
            }.let { run.graded(compiled.replaced.applied(it), submission.notes + start.notes + compiled.notes) }
    }

    private fun read(given: Path, work: Path): Submission =
        try {
            SubmissionReader.read(Readable.of(given, work.resolve("copy")), work.resolve("unpacked"), edition)
        } catch (e: NotASubmission) {
            throw Stopped(FailureReason.NOT_RECOGNIZED, e.message.orEmpty())
        } catch (e: InputError) {
            throw Stopped(FailureReason.UNPACK_REFUSED, e.message.orEmpty())
        }

    private fun compile(submission: Submission, scratch: Path, run: Run): Compiled {
        val window = submission.sources.firstOrNull {
            it.packageName == "cga.framework" &&
                it.path.fileName.toString().substringBeforeLast('.') == "GameWindow"
        }
        val standIn = mapOf("cga.framework.GameWindow" to programs.standIn(window?.text))

        // A folder for each round: what was left out must not lie about.
        var rounds = 0

        fun compile(sources: List<SourceFile>) =
            try {
                compiler.compile(submission.with(sources), scratch.resolve("${++rounds}").createDirectories(), standIn)
            } catch (e: LibraryUnavailable) {
                throw Stopped(FailureReason.NO_COMPILER, e.message.orEmpty())
            }
        val result = compile(submission.sources)
        run.compiler = result.compiler
        result.classes?.let { return Compiled(it, result.runtime, result.notes) }
        val lines = lines(result)
        run.log("compiler", lines.joinToString("\n"))
        val repaired = Repair(submission, ::compile).repaired(result)
        val classes = repaired?.result?.classes ?: throw Stopped(FailureReason.DOES_NOT_COMPILE, lines.take(MOST_ERRORS).joinToString("\n"))
        run.compiler = repaired.result.compiler
        val files = repaired.files.map { "$it does not compile: " + if (it in repaired.leftOut) LEFT_OUT else REPLACED }
        val notes = (result.notes + files + lines.take(MOST_ERRORS) + repaired.result.notes).distinct()
        return Compiled(classes, repaired.result.runtime, notes, ReplacedFiles(repaired.files))
    }

    private fun lines(result: CompileResult) =
        result.errors.map { e -> listOfNotNull(e.file, e.line.takeIf { it > 0 }).joinToString(":") + ": " + e.message }

    private companion object {
        const val MOST_ERRORS = 5
        const val REPLACED = "the reference's file took its place."
        const val LEFT_OUT = "it was left out."
    }
}

/**
 * A submission's classes, the libraries they need besides ours, what the report should say of how they were compiled, and which of its files
 * were replaced.
 */
internal class Compiled(
    val classes: Path,
    val runtime: List<Path>,
    val notes: List<String>,
    val replaced: ReplacedFiles = ReplacedFiles(emptyList()),
)

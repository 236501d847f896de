package cga.grading.pipeline

import cga.grading.compile.CompileResult
import cga.grading.compile.CompilerCache
import cga.grading.compile.LibraryUnavailable
import cga.grading.compile.Repair
import cga.grading.compile.SubmissionCompiler
import cga.grading.course.CheckListener
import cga.grading.course.GradeOne
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import cga.grading.findings.Likeness
import cga.grading.findings.Outcome
import cga.grading.findings.Part
import cga.grading.prepared.Edition
import cga.grading.prepared.PreparedSource
import cga.grading.prepared.PreparedTree
import cga.grading.sandbox.Sandbox
import cga.grading.sandbox.Scratch
import java.nio.file.Path
import kotlin.io.path.createDirectories

/**
 * From a folder or an archive to what was measured of it: unpack, compile, run, measure. Each step that touches what a student wrote is a
 * process of its own in [sandbox]; a step that fails ends it with the reason.
 *
 * @param edition the sheet's, null where each submission's is detected.
 * @param home where the compilers and the worker are kept between runs.
 * @param limits of each step.
 * @param comparesSolutions whether it is noted what of a submission is the same as in our own solutions.
 * @param sharesCompiler whether submissions that compile are compiled in one process after another, rather than each in its own.
 */
public class Pipeline(
    private val sandbox: Sandbox,
    edition: Edition?,
    home: Path,
    private val limits: PipelineLimits = PipelineLimits(),
    sharesCompiler: Boolean = false,
    comparesSolutions: Boolean = false,
) : GradeOne {
    private val programs = Programs(home)
    private val compiler =
        SubmissionCompiler(sandbox, CompilerCache(home), programs.forSubmissions, limits.compile, programs.own.takeIf { sharesCompiler })

    private val prepare = PrepareStep(sandbox, programs, limits.prepare, edition)
    private val capture = CaptureStep(sandbox, programs, limits.run)
    private val measure = MeasureStep(sandbox, programs, limits.measure)
    private val solutions = if (comparesSolutions) Solutions(programs.home, programs.state, ::likeness) else null

    override fun grade(submission: Path, folder: Path, listener: CheckListener): Outcome {
        val work = folder.toRealPath().resolve("work").createDirectories()
        val run = Run(sandbox.isConfined)
        return try {
            grade(submission, folder, work, run, solutions).also { if (it is Graded) it.findings.checks.forEach(listener::measured) }
        } catch (e: Stopped) {
            // Nobody is blamed for what a full disk may have done.
            val full = DiskSpace.lack(work, limits.run.diskBytes).takeIf { e.reason.isItsOwn }
            if (full == null) run.refused(e.reason, e.detail) else run.refused(FailureReason.INTERNAL, "$full It ended so: ${e.detail}")
        } finally {
            Scratch.delete(work)
        }
    }

    override fun close(): Unit = compiler.close()

    private fun likeness(project: Path, work: Path): Likeness =
        Run(sandbox.isConfined).also { grade(project, work, work, it, solutions = null) }.likeness()

    private fun grade(given: Path, folder: Path, work: Path, run: Run, solutions: Solutions?): Outcome {
        fun folder(name: String) = work.resolve(name).createDirectories()
        val tree = run.timed("unpack") { prepare.prepare(given, folder("prepare")) }
        val manifest = tree.manifest
        run.kind = manifest.kind.name.lowercase()
        run.edition = manifest.edition.title
        manifest.sourcesKey?.let { run.compare(mapOf(Part.KOTLIN to it)) }
        solutions?.let { run.solution = it.of(manifest.kind) }
        val main = manifest.mainClass ?: throw Stopped(FailureReason.NOT_RECOGNIZED, "There is no main function to start.")
        val compiled = run.timed("compile") { compile(tree, folder("compile"), run) }
        val capture = run.timed("run") { capture.capture(tree, main, compiled, folder("run"), run) }
        val findings = run.timed("measure") { measure.measure(manifest.edition, capture, folder("measure"), folder, run) }
        return run.graded(Excerpts(tree).applied(compiled.replaced.applied(findings)), manifest.notes + compiled.notes)
    }

    private fun compile(tree: PreparedTree, scratch: Path, run: Run): Compiled {
        // A folder for each round: what was left out must not lie about.
        var rounds = 0

        fun round() = scratch.resolve("${++rounds}").createDirectories()

        fun compile(replaced: Set<PreparedSource>) =
            try {
                compiler.compile(tree, tree.files(replaced), round())
            } catch (e: LibraryUnavailable) {
                throw Stopped(FailureReason.NO_COMPILER, e.message.orEmpty())
            }
        val result = compile(emptySet())
        run.compiler = result.compiler
        result.classes?.let { return Compiled(it, result.runtime, result.notes) }
        val lines = lines(result)
        run.log("compiler", lines.joinToString("\n"))
        val repair =
            Repair(
                tree.manifest.sources,
                ::compile,
            ) { alone -> compiler.isBrokenBy(tree, tree.files().filterKeys(alone::contains), round()) }
        val repaired = repair.repaired(result)
        val classes = repaired?.result?.classes ?: throw Stopped(FailureReason.DOES_NOT_COMPILE, lines.take(MOST_ERRORS).joinToString("\n"))
        run.compiler = repaired.result.compiler
        val files = repaired.files.map { "${it.name} does not compile: " + if (it.hasReference) REPLACED else LEFT_OUT }
        val notes = (result.notes + files + lines.take(MOST_ERRORS) + repaired.result.notes).distinct()
        return Compiled(classes, repaired.result.runtime, notes, ReplacedFiles(repaired.files.map { it.name }))
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
    val classes: List<Path>,
    val runtime: List<Path>,
    val notes: List<String>,
    val replaced: ReplacedFiles = ReplacedFiles(emptyList()),
)

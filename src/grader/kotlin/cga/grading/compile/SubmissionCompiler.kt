package cga.grading.compile

import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.Sandbox
import cga.grading.sandbox.Scratch
import cga.grading.submission.Submission
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists

/**
 * Compiles submissions inside a sandbox: with the newest Kotlin at its lowest level, then, where that fails, with the version that the
 * build file names. Never runs a build script.
 *
 * @param libraries what submissions are compiled against besides the Kotlin standard library: LWJGL, JOML.
 * @param shared the class path of this program where submissions share a compiler as long as they compile; null where each has a process of
 * its own in any case.
 */
public class SubmissionCompiler(
    private val sandbox: Sandbox,
    private val compilers: CompilerCache,
    private val libraries: List<Path>,
    private val limits: Limits = Limits(wallSeconds = 120.0, cpuSeconds = 180.0),
    private val shared: List<Path>? = null,
) : AutoCloseable {
    private val warm = SharedCompilers { SharedCompiler(sandbox, compilers.newest(), shared.orEmpty(), libraries) }

    /**
     * Compiles [submission] in [scratch], an existing folder of its own.
     *
     * @param replacements Kotlin sources by the qualified names of the classes that they take the place of; a file of the submission that
     * declares one is left out as a whole.
     *
     * Throws [LibraryUnavailable] when there is no newest compiler; what is wrong with the submission is in the result.
     */
    public fun compile(submission: Submission, scratch: Path, replacements: Map<String, String> = emptyMap()): CompileResult {
        val stage = Stage(scratch.toRealPath().resolve("sources"), submission.sources, replacements)
        val plain = attempt(compilers.newest(), stage, scratch.toRealPath())
        if (plain.classes != null) return plain
        // Most of what build files name nobody uses: it is fetched where something is missing.
        val further = compilers.further(submission.libraries, libraries)
        val first =
            if (further.jars.isEmpty()) plain else attempt(compilers.newest(), stage, scratch.toRealPath(), further.jars)
        if (first.classes != null) return first
        return older(submission, stage, scratch, first.noting(further.notes), further)
    }

    /** What the compiler that the build file names says where the newest said [first]. */
    private fun older(
        submission: Submission,
        stage: Stage,
        scratch: Path,
        first: CompileResult,
        further: FurtherLibraries,
    ): CompileResult {
        val older = try {
            compilers.named(submission.versions.kotlin)
        } catch (e: LibraryUnavailable) {
            return first.noting(listOf("No other compiler could be tried: ${e.message}"))
        } catch (e: IllegalArgumentException) {
            return first.noting(listOf("No other compiler could be tried: ${e.message}"))
        }
        if (older.version == CompilerCache.NEWEST) return first
        val second = attempt(older, stage, scratch.toRealPath(), further.jars)
        val failed = "It does not compile with ${first.compiler}"
        return if (second.classes != null) {
            second.noting(further.notes + "$failed, but with ${second.compiler}.")
        } else {
            // The compiler that the student had says what the student saw.
            second.noting(further.notes + "$failed either (${first.errors.size} errors).")
        }
    }

    /** @param further libraries besides those of every submission. */
    private fun attempt(compiler: KotlinCompiler, stage: Stage, scratch: Path, further: List<Path> = emptyList()): CompileResult {
        val classes = scratch.resolve("classes")
        if (classes.exists()) Scratch.delete(classes)
        classes.createDirectories()
        val isShared = shared != null && compiler == compilers.newest() && further.isEmpty()
        var outcome = if (isShared && warm.compiles(stage.folders, classes)) null else alone(compiler, stage, classes, scratch, further)
        if (outcome?.isSuccess != false && stage.javaFiles.isNotEmpty()) {
            outcome = run(javac(compiler, stage, classes, further), compiler.readable + libraries + further, scratch)
        }
        val errors = outcome?.let { CompilerOutput.errors(it, stage) }.orEmpty()
        val runtime = listOf(compilers.newest().stdlib) + further
        return CompileResult(classes.takeIf { errors.isEmpty() }, runtime, compiler.title, errors, stage.notes)
    }

    /** By a process that this one submission has for itself. */
    private fun alone(compiler: KotlinCompiler, stage: Stage, classes: Path, scratch: Path, further: List<Path>): Outcome {
        val readable = (libraries + further).map { compilers.readable(it, compiler) }
        return run(compiler.command(stage.folders, readable, classes), compiler.readable + readable, scratch)
    }

    private fun run(command: List<String>, readOnly: List<Path>, scratch: Path): Outcome =
        sandbox.run(Job(command, scratch, readOnly, limits = limits))

    private fun javac(compiler: KotlinCompiler, stage: Stage, classes: Path, further: List<Path>): List<String> {
        val classPath = (listOf(classes, compiler.stdlib) + libraries + further).joinToString(":")
        return listOf("${Path.of(System.getProperty("java.home"), "bin", "javac")}", "-J-XX:TieredStopAtLevel=1", "-J-XX:+UseSerialGC") +
            listOf("-proc:none", "-nowarn", "-encoding", "UTF-8", "-d", "$classes", "-cp", classPath) + stage.javaFiles.map { "$it" }
    }

    /** Ends the processes of shared compilers. */
    override fun close(): Unit = warm.close()

    private fun CompileResult.noting(more: List<String>) = CompileResult(classes, runtime, compiler, errors, notes + more)
}

package cga.grading.compile

import cga.grading.prepared.PreparedSource
import cga.grading.prepared.PreparedTree
import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.SafeFiles
import cga.grading.sandbox.Sandbox
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteIfExists

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
     * Compiles [files] of [tree] in [scratch], an existing folder of its own.
     *
     * Throws [LibraryUnavailable] when there is no newest compiler; what is wrong with the submission is in the result.
     */
    internal fun compile(tree: PreparedTree, files: Map<PreparedSource, Path>, scratch: Path): CompileResult {
        val task = Task(tree, files, scratch.toRealPath())
        val plain = attempt(compilers.newest(), task)
        if (plain.classes != null) return plain
        // Most of what build files name nobody uses: it is fetched where something is missing.
        val further = compilers.further(tree.manifest.libraries, libraries)
        val first = if (further.jars.isEmpty()) plain else attempt(compilers.newest(), task, further.jars)
        if (first.classes != null) return first
        return older(task, first.noting(further.notes), further)
    }

    /** Whether the newest compiler itself fails at [files] of [tree], rather than finding errors in them. */
    internal fun isBrokenBy(tree: PreparedTree, files: Map<PreparedSource, Path>, scratch: Path): Boolean {
        val compiler = compilers.newest()
        val outcome = alone(compiler, Task(tree, files, scratch.toRealPath()), emptyList(), SHORT)
        return CompilerOutput(files.keys.toList()).errors(outcome).any { it.isCompilers }
    }

    /** What is to be compiled, and where. */
    private class Task(
        val tree: PreparedTree,
        val files: Map<PreparedSource, Path>,
        val scratch: Path,
    ) {
        val output = CompilerOutput(files.keys.toList())
        val java = files.filterKeys { !it.isKotlin }.values
        val jar: Path = scratch.resolve(JAR)
    }

    /** What the compiler that the build file names says where the newest said [first]. */
    private fun older(task: Task, first: CompileResult, further: FurtherLibraries): CompileResult {
        val older = try {
            compilers.named(task.tree.manifest.kotlin)
        } catch (e: LibraryUnavailable) {
            return first.noting(listOf("No other compiler could be tried: ${e.message}"))
        } catch (e: IllegalArgumentException) {
            return first.noting(listOf("No other compiler could be tried: ${e.message}"))
        }
        if (older.version == CompilerCache.NEWEST) return first
        val second = attempt(older, task, further.jars)
        val failed = "It does not compile with ${first.compiler}"
        return if (second.classes != null) {
            second.noting(further.notes + "$failed, but with ${second.compiler}.")
        } else {
            // The compiler that the student had says what the student saw.
            second.noting(further.notes + "$failed either (${first.errors.size} errors).")
        }
    }

    /** @param further libraries besides those of every submission. */
    private fun attempt(compiler: KotlinCompiler, task: Task, further: List<Path> = emptyList()): CompileResult {
        task.jar.deleteIfExists()
        val isShared = shared != null && compiler == compilers.newest() && further.isEmpty()
        var outcome = if (isShared && warm.compiles(task.files.values, task.jar)) null else alone(compiler, task, further, limits)
        val classes = mutableListOf(task.jar)
        if (outcome?.isSuccess != false && task.java.isNotEmpty()) {
            val folder = task.scratch.resolve("java").createDirectories().also(classes::add)
            outcome = run(javac(compiler, task, folder, further), compiler.readable + libraries + further, task, limits)
        }
        val errors = outcome?.let(task.output::errors).orEmpty()
        val isThere = errors.isEmpty() && SafeFiles.exists(task.scratch, JAR) && classes.drop(1).all(SafeFiles::isFolder)
        val runtime = listOf(compilers.newest().stdlib) + further
        return CompileResult(classes.takeIf { isThere }, runtime, compiler.title, errors, emptyList())
    }

    /** By a process that this one submission has for itself. */
    private fun alone(compiler: KotlinCompiler, task: Task, further: List<Path>, limits: Limits): Outcome {
        val readable = (libraries + further).map { compilers.readable(it, compiler) }
        return run(compiler.command(task.files.values.toList(), readable, task.jar), compiler.readable + readable, task, limits)
    }

    private fun run(command: List<String>, readOnly: List<Path>, task: Task, limits: Limits): Outcome =
        sandbox.run(Job(command, task.scratch, readOnly + task.tree.sourceFolders, limits = limits))

    private fun javac(compiler: KotlinCompiler, task: Task, classes: Path, further: List<Path>): List<String> {
        val classPath = (listOf(task.jar, compiler.stdlib) + libraries + further).joinToString(":")
        return listOf("${Path.of(System.getProperty("java.home"), "bin", "javac")}", "-J-XX:TieredStopAtLevel=1", "-J-XX:+UseSerialGC") +
            listOf("-proc:none", "-nowarn", "-encoding", "UTF-8", "-d", "$classes", "-cp", classPath) + task.java.map { "$it" }
    }

    /** Ends the processes of shared compilers. */
    override fun close(): Unit = warm.close()

    private fun CompileResult.noting(more: List<String>) = CompileResult(classes, runtime, compiler, errors, notes + more)

    private companion object {
        const val JAR = "classes.jar"

        /** A compiler that has nothing but errors to tell takes a fifth of it. */
        val SHORT = Limits(wallSeconds = 60.0, cpuSeconds = 30.0)
    }
}

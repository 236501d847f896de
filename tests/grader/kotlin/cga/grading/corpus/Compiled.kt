package cga.grading.corpus

import cga.testing.projectRoot
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream
import java.nio.file.Path

/** Kotlin compiled in this process, against the libraries of the tests and none of our own classes. */
internal object Compiled {
    /** The jars on this process's class path that were not made here. */
    val libraries: String =
        System
            .getProperty("java.class.path")
            .split(File.pathSeparator)
            .filter { it.endsWith(".jar") && !File(it).startsWith(projectRoot) }
            .joinToString(File.pathSeparator)

    /**
     * Compiles all Kotlin below [folders], against [more] libraries, into [target]; returns what the compiler has to complain of, nothing
     * when all is well.
     */
    fun complaints(
        folders: List<Path>,
        target: Path,
        more: List<Path> = emptyList(),
    ): String {
        val sources = folders.flatMap { folder -> folder.toFile().walk().filter { it.extension == "kt" }.map { "$it" } }
        val log = ByteArrayOutputStream()
        // The formatter's compiler is older than the standard library, whose metadata it can read nevertheless.
        val options = listOf("-no-stdlib", "-no-reflect", "-nowarn", "-jvm-target", "17", "-Xskip-metadata-version-check")
        val arguments =
            options + listOf(
                "-cp",
                (
                    listOf(
                        libraries,
                    ) + more
                ).joinToString(File.pathSeparator),
                "-d", "$target", "-module-name", "student",
            ) +
                sources
        val exit = K2JVMCompiler().exec(PrintStream(log), *arguments.toTypedArray())
        return if (exit == ExitCode.OK) "" else "$exit\n$log"
    }
}

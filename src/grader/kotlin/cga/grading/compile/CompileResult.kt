package cga.grading.compile

import cga.grading.prepared.PreparedSource
import java.nio.file.Path

/**
 * What became of a submission's sources.
 *
 * @param classes the jars and folders with the compiled classes, null when they do not compile.
 * @param runtime the libraries that the classes must be run with, besides those that were given: the Kotlin standard library, and those of
 * the build file's that it needs.
 * @param compiler which compiler at which level, for the report.
 * @param errors what is wrong, in the compiler's order; empty when it compiles.
 * @param notes what else the report should say, in full sentences.
 */
public class CompileResult(
    public val classes: List<Path>?,
    public val runtime: List<Path>,
    public val compiler: String,
    public val errors: List<CompileError>,
    public val notes: List<String>,
)

/**
 * An error of a compiler.
 *
 * @param source the file, null where it is about none.
 * @param line from 1 on, 0 where there is none.
 */
public data class CompileError(
    public val source: PreparedSource?,
    public val line: Int,
    public val message: String,
) {
    /** Whether it says that the compiler failed, and not what is wrong where. */
    internal val isCompilers: Boolean get() = line == 0

    /** How the submission calls it. */
    public val file: String? get() = source?.name
}

package cga.grading.submission

import cga.framework.InputError
import java.nio.file.Path

/** Which way a submission came to be. */
public enum class Kind {
    /** A folder made by `./cga starter`, filled in. */
    STARTER,

    /** A project of the course itself. */
    COURSE,
}

/**
 * What a student handed in, as far as it can be told by looking at files. Nothing of it has been run.
 *
 * @param name to call it by: the file name of what was handed in, without its extension.
 * @param root the folder that all of it lies in, absolute.
 * @param sources what is to be compiled, in order of their names.
 * @param workingDirectory where it expects to be started: the folder that holds `assets/`.
 * @param mainClass the class to start, null where none was found.
 * @param versions the libraries' versions that its build files name.
 * @param notes what was noticed and may matter, in full sentences.
 * @param libraries that its build files name, whether it needs them or not.
 */
public class Submission(
    public val name: String,
    public val root: Path,
    public val kind: Kind,
    public val sources: List<SourceFile>,
    public val workingDirectory: Path,
    public val mainClass: String?,
    public val versions: Versions,
    public val edition: DetectedEdition,
    public val notes: List<String>,
    public val libraries: List<NamedLibrary> = emptyList(),
) {
    /** The same with other [sources]. */
    internal fun with(sources: List<SourceFile>): Submission =
        Submission(name, root, kind, sources, workingDirectory, mainClass, versions, edition, notes, libraries)
}

/** Nothing that can be graded; the message says why. */
public class NotASubmission(message: String) : InputError(message)

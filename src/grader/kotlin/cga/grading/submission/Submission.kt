package cga.grading.submission

import cga.framework.InputError
import cga.grading.prepared.Edition
import cga.grading.prepared.Kind
import cga.grading.prepared.NamedLibrary
import java.nio.file.Path

/**
 * What a student handed in, as far as it can be told by looking at files. Nothing of it has been run.
 *
 * @param tree all of it, with the folder that it lies in, absolute.
 * @param sources what is to be compiled, in order of their names.
 * @param workingDirectory where it expects to be started: the folder that holds `assets/`.
 * @param mainClass the class to start, null where none was found.
 * @param kotlin the version that its build files name, null where they name none.
 * @param notes what was noticed and may matter, in full sentences.
 * @param libraries that its build files name, whether it needs them or not.
 */
internal class Submission(
    val tree: FileTree,
    val kind: Kind,
    val sources: List<SourceFile>,
    val workingDirectory: Path,
    val mainClass: String?,
    val kotlin: String?,
    val edition: DetectedEdition,
    val notes: List<String>,
    val libraries: List<NamedLibrary>,
) {
    val root: Path get() = tree.root
}

/** An edition and what speaks for it: where in the sources it shows, or that it was asked for. */
internal class DetectedEdition(
    val edition: Edition,
    val evidence: List<String>,
) {
    companion object {
        /** The edition that most in [sources] speaks for; the sheet's own where nothing does. */
        fun of(sources: List<SourceFile>): DetectedEdition =
            Edition.ALL.map { DetectedEdition(it, evidence(it, sources)) }.maxBy { it.evidence.size }

        private fun evidence(edition: Edition, sources: List<SourceFile>) =
            edition.evidence.mapNotNull { (what, pattern) ->
                val regex = Regex(pattern)
                sources.firstOrNull { regex.containsMatchIn(it.text) }?.let { "$what in ${it.name}" }
            }
    }
}

/** Nothing that can be graded; the message says why. */
internal open class NotASubmission(message: String) : InputError(message)

/** An archive that cannot or must not be unpacked. */
internal class BadArchive(message: String) : NotASubmission(message)

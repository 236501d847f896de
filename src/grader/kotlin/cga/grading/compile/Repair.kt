package cga.grading.compile

import cga.grading.submission.SourceFile
import cga.grading.submission.Submission

/**
 * Compiles a submission some of whose files have errors: those are replaced by the files of the same name of a correct project, or left out
 * where it has none, round by round, as each round may show errors that were hidden or new.
 *
 * @param compile compiles these sources of the submission.
 */
internal class Repair(
    private val submission: Submission,
    private val compile: (List<SourceFile>) -> CompileResult,
) {
    /** The result of the last round, the names of the [files] that are not the submission's any more, and those of them [leftOut]. */
    class Repaired(
        val result: CompileResult,
        val files: List<String>,
        val leftOut: List<String>,
    )

    /** What becomes of the submission, which failed with [first]; null where no round helps. */
    fun repaired(first: CompileResult): Repaired? {
        var sources = submission.sources
        var failed = first
        val replaced = LinkedHashSet<String>()
        repeat(MOST_ROUNDS) {
            val names = failed.errors.mapNotNull { it.file }.toSet()
            val wrong = sources.filter { it.name in names }
            // An error elsewhere than in a file, in our stand-in, or in a file that is the reference's: nothing more can be done.
            if (wrong.isEmpty() || wrong.any { it.name in replaced } || failed.errors.any { it.file == null }) return null
            replaced += wrong.map { it.name }
            sources = sources.mapNotNull { if (it in wrong) ReferenceSources.like(it, submission.kind) else it }
            failed = compile(sources)
            if (failed.classes != null) {
                val kept = sources.map { it.name }.toSet()
                return Repaired(failed, replaced.toList(), (replaced - kept).toList())
            }
        }
        return null
    }

    private companion object {
        const val MOST_ROUNDS = 4
    }
}

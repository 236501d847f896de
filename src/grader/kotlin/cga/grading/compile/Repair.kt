package cga.grading.compile

import cga.grading.prepared.PreparedSource

/**
 * Compiles a submission some of whose files have errors: those are replaced by the files of the same name of a correct project, or left out
 * where it has none, round by round, as each round may show errors that were hidden or new.
 *
 * @param compile compiles the submission without these sources of its own.
 * @param breaks whether the compiler itself fails at these sources alone.
 */
internal class Repair(
    private val sources: List<PreparedSource>,
    private val compile: (Set<PreparedSource>) -> CompileResult,
    private val breaks: (List<PreparedSource>) -> Boolean,
) {
    /** The result of the last round, and the [files] that are not the submission's any more. */
    class Repaired(
        val result: CompileResult,
        val files: List<PreparedSource>,
    )

    /** What becomes of the submission, which failed with [first]; null where no round helps. */
    fun repaired(first: CompileResult): Repaired? {
        var failed = first
        val replaced = LinkedHashSet<PreparedSource>()
        repeat(MOST_ROUNDS) {
            val wrong = wrong(failed, replaced)
            // An error elsewhere than in a file, in our stand-in, or in a file that is the reference's: nothing more can be done.
            if (wrong.isEmpty() || wrong.any { it.isOurs || it in replaced }) return null
            replaced += wrong
            failed = compile(replaced)
            if (failed.classes != null) return Repaired(failed, replaced.toList())
        }
        return null
    }

    private fun wrong(failed: CompileResult, replaced: Set<PreparedSource>): Set<PreparedSource> {
        val named = failed.errors.mapNotNull { it.source }.toSet()
        return if (failed.errors.any { it.source == null }) {
            setOfNotNull(
                breaking(sources.filterNot { it.isOurs || it in replaced }),
            )
        } else {
            named
        }
    }

    /** The one of [suspects] at which the compiler fails, found by halves; null where it fails at none by itself. */
    private fun breaking(suspects: List<PreparedSource>): PreparedSource? {
        if (suspects.size < 2) return suspects.firstOrNull()?.takeIf { breaks(suspects) }
        val (first, second) = suspects.chunked((suspects.size + 1) / 2)
        return breaking(if (breaks(first)) first else second)
    }

    private companion object {
        const val MOST_ROUNDS = 4
    }
}

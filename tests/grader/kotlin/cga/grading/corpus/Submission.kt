package cga.grading.corpus

/** Editions of the course's sheet. */
internal enum class Edition { SHEET, LATER }

/**
 * A submission of the corpus: the course project, rewritten.
 *
 * @param set what it was written with: `rewrites`, `students`, `mistakes`, or the name of a set that was held out.
 * @param rewrites names of [Rewrite]s in the order in which they are applied.
 */
internal class Submission(
    val name: String,
    val edition: Edition,
    val rewrites: List<String>,
    val expectation: Expectation,
    val set: String,
) {
    override fun toString(): String = name
}

package cga.grading.corpus

/** Editions of the course's sheet. */
internal enum class Edition { SHEET, LATER }

/**
 * A submission of the corpus: the course project, rewritten.
 *
 * @param rewrites names of [Rewrite]s in the order in which they are applied.
 */
internal class Submission(
    val name: String,
    val edition: Edition,
    val rewrites: List<String>,
    val expectation: Expectation,
) {
    override fun toString(): String = name
}

package cga.grading.corpus

import cga.grading.findings.Mistake

/**
 * What a grader should say of a submission.
 *
 * @param mistakes to be named, each once; where a set has several, any of them is right. Empty for a correct submission.
 * @param costs ids of the checks that may lose points; one of them does, and no other.
 * @param points what a person would give; null where they follow from the mistakes.
 */
internal class Expectation(
    val mistakes: List<Set<Mistake>>,
    val costs: Set<String>,
    val points: Double? = null,
) {
    /** The tasks that they belong to. */
    val tasks: Set<String> = costs.map { id -> id.split('.').take(2).joinToString(".") }.toSet()

    companion object {
        val CORRECT = Expectation(emptyList(), emptySet())
    }
}

package cga.grading.corpus

import cga.grading.findings.Check
import cga.grading.rubric.Rubric

/** The points that a submission should have: each of its mistakes costs once, at its own check. */
internal object ExpectedPoints {
    fun of(
        expectation: Expectation,
        rubric: Rubric,
    ): Double = expectation.points ?: (rubric.total - losses(expectation, rubric).values.sum())

    /** By the id of the check. Of mistakes that are as right as each other the one that costs least is meant. */
    private fun losses(
        expectation: Expectation,
        rubric: Rubric,
    ): Map<String, Double> {
        val losses = HashMap<String, Double>()
        for (either in expectation.mistakes) {
            val (check, cost) =
                either
                    .map { mistake ->
                        val check = mistake.check.takeIf { it.id in expectation.costs } ?: byId.getValue(expectation.costs.first())
                        check.id to rubric.rule(check).points * rubric.cost(mistake)
                    }.minBy { it.second }
            losses.merge(check, cost, ::maxOf)
        }
        return losses
    }

    private val byId = Check.entries.associateBy { it.id }
}

package cga.grading.corpus

import cga.grading.findings.Check
import cga.grading.findings.Mistake

/**
 * What a grader should say of a submission.
 *
 * @param mistakes to be named, each once; where a set has several, any of them is right. Empty for a correct submission.
 * @param stated ids of the checks that they may cost, beside those of what is not there.
 */
internal class Expectation(
    val mistakes: List<Set<Mistake>>,
    stated: Set<String>,
) {
    /** Ids of the checks that may lose points; one of them does, and no other. */
    val costs: Set<String> = stated + mistakes.flatten().flatMap { ABSENT[it].orEmpty() }.map { it.id }

    /** The tasks that they belong to. */
    val tasks: Set<String> = costs.map { id -> id.split('.').take(2).joinToString(".") }.toSet()

    companion object {
        val CORRECT = Expectation(emptyList(), emptySet())

        /** What earns nothing because there is nothing. */
        private val ABSENT: Map<Mistake, Set<Check>> =
            mapOf(
                Mistake.LIGHT_MISSING to
                    setOf(Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.ATTENUATION_POINT, Check.LIGHT_COLOR),
                Mistake.SPOT_MISSING to
                    setOf(Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.CONE_SPECULAR, Check.ATTENUATION_SPOT),
                Mistake.MORE_LIGHTS_MISSING to setOf(Check.MORE_LIGHTS_SHADING),
                Mistake.ORBIT_MISSING to setOf(Check.ORBIT_PIVOT, Check.ORBIT_HORIZON, Check.ORBIT_FACTOR, Check.ORBIT_START),
            )
    }
}

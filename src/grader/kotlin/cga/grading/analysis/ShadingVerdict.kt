package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured

/**
 * What the study of the shaders says, as plain data.
 *
 * @param checks at most one entry for a check; those that shaders decide.
 * @param mistakes each once; [Found.where] names the lights that have it by their colours' uniforms, with commas between them.
 */
internal class ShadingVerdict(
    val checks: List<Measured>,
    val mistakes: List<Found>,
) {
    /** The entry for [check], or null. */
    operator fun get(check: Check): Measured? = checks.find { it.check == check }
}

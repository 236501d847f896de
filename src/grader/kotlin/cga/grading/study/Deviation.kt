package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Mistake

/**
 * A mistake seen in the shading of one light, or of the program as a whole.
 *
 * @param light the submission's name of the light's colour; empty where it concerns no light.
 * @param fit what the hypothesis leaves unexplained, relative; 0 is all explained.
 * @param difference how far this is from right, relative: 1 is all of it.
 * @param check what it costs; of something unknown where it was seen.
 * @param why what is known of something that has no name, as a sentence.
 */
internal class Deviation(
    val mistake: Mistake,
    val light: String,
    val fit: Double,
    val difference: Double,
    val alternatives: List<Mistake> = emptyList(),
    val check: Check = mistake.check,
    val why: String = "",
)

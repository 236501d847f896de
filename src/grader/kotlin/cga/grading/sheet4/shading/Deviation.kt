package cga.grading.sheet4.shading

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.reading.ShaderLine

/**
 * An axis of the model on which a shader is not as the sheet has it.
 *
 * @property light the submission's name of the light, empty where it concerns no single one.
 * @property error how far the quantity is from right with all else right, relative: 1 is all of it.
 * @property text what to say, a key of the message files.
 */
internal class Deviation(
    val mistake: Mistake,
    val light: String,
    val error: Double,
    val line: ShaderLine?,
    val check: Check = mistake.check,
    val text: String = "",
)

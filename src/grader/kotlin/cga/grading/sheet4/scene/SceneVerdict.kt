package cga.grading.sheet4.scene

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake

/**
 * What the scene does over the frames, judged.
 *
 * @param checks at most one entry for a check; [SceneJudge.CHECKS] says which.
 * @param mistakes most telling first.
 * @param notes what else a grader should know.
 * @param unlit names of the lights that give no light in any frame: whatever is said of their shading is said of nothing. Among them are all
 * uniforms that are 0 for ever, and those that the sources declare and no program has: the compiler drops what nothing is made of.
 * @param spot name of the light that was taken for the headlight, null where none was.
 * @param isReplaced whether shaders that the driver refused were replaced by stand-ins, so that no shading can be seen.
 */
public class SceneVerdict(
    public val checks: List<Measured>,
    public val mistakes: List<Found>,
    public val notes: List<Message>,
    public val unlit: Set<String> = emptySet(),
    public val isReplaced: Boolean = false,
    public val spot: String? = null,
) {
    /** The entry for [check], or null. */
    public operator fun get(check: Check): Measured? = checks.find { it.check == check }

    /** The entry for [mistake], or null. */
    public operator fun get(mistake: Mistake): Found? = mistakes.find { it.mistake == mistake }
}

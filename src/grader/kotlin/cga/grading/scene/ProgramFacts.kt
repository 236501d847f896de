package cga.grading.scene

import cga.grading.capture.Moment

/**
 * What is known of a submission's programs beside what they draw.
 *
 * @param unset active uniforms, samplers apart, that are 0 in every draw; null where nobody looked.
 * @param idle whole numbers and truth values that are 0 in every draw: a count of lights that never arrived, or a choice.
 * @param declares whether the shaders declare a uniform of that name: then it is spelt right, even if the compiler dropped it.
 * @param drawn the moments at which anything was drawn at all.
 * @param canCone whether the shaders could limit a light to a cone, while none has one.
 * @param deadly uniforms that nobody sends and that leave no number of the picture: something is divided by them.
 * @param lent names of lights in whose colour another one shines too, where none has a cone; [strange] of those that shine unevenly, and in
 * no cone around a direction.
 * @param isReplaced whether all that is drawn is drawn by stand-ins for shaders that the driver refused.
 * @param isRead whether the sheet's own lighting could take their place, so that all but the shading can be seen; [isReadWhole] whether it
 * is clear what each number that was sent means, so that what cannot be seen is not there.
 */
public class ProgramFacts(
    public val unset: Set<String>? = null,
    public val declares: (String) -> Boolean = { false },
    public val drawn: Set<Moment> = emptySet(),
    public val isReplaced: Boolean = false,
    public val isRead: Boolean = false,
    public val isReadWhole: Boolean = false,
    public val canCone: Boolean = false,
    public val deadly: Set<String> = emptySet(),
    public val idle: Set<String> = emptySet(),
    public val lent: Set<String> = emptySet(),
    public val strange: Set<String> = emptySet(),
)

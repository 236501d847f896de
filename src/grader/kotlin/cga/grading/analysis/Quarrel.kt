package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.sheet4.scene.SceneVerdict

/** Where study and scene judge the same thing: which of their mistakes are to be believed. */
internal class Quarrel(
    private val shadingVerdict: ShadingVerdict,
    private val sceneVerdict: SceneVerdict,
) {
    private val seen = if (sceneVerdict.isReplaced) emptyList() else shadingVerdict.mistakes

    /** Of the study: what it says of lights that never shine. */
    val unfounded: List<Found> = seen.filter { lights(it).isNotEmpty() && lights(it).all(sceneVerdict.unlit::contains) }

    /** Of the study: what is believed. */
    val shading: List<Found> = (seen - unfounded.toSet()).filterNot(::sceneKnowsBetter)

    /** Of the scene: what is believed. */
    val scene: List<Found> = sceneVerdict.mistakes.filterNot(::studyKnowsBetter)

    private fun lights(found: Found) = found.where.split(", ").filter { it.isNotEmpty() }

    private fun sceneKnowsBetter(found: Found): Boolean =
        when (found.mistake) {
            // A single frame can mislead; the scene follows the direction over all.
            in DIRECTION -> sceneVerdict[Check.SPOT_DIRECTION]?.error != null
            // It has seen the numbers arrive, of the one light that it looked at.
            Mistake.CONE_NEVER_SENT ->
                sceneVerdict[Check.CONE].isRight() && sceneVerdict[Check.SPOT_DIRECTION].isRight() && !isOfOthers(found)
            // Lights that come after a test for the cone end at its edge, too.
            Mistake.CONE_HARD_EDGE -> isOfOthers(found) && seen.any { it.mistake == Mistake.UNKNOWN }
            in CONE -> sceneVerdict.mistakes.any(::breaksTie)
            else -> false
        }

    private fun isOfOthers(found: Found): Boolean {
        val spot = sceneVerdict.spot ?: return false
        return lights(found).isNotEmpty() && spot !in lights(found)
    }

    private fun studyKnowsBetter(found: Found): Boolean =
        when (found.mistake) {
            // The study sees the whole curve; the scene the numbers that make it.
            in CONE ->
                !breaksTie(found) &&
                    (
                        shading.any { it.mistake in CONE || isUnknownCone(it, found) } ||
                            (found.mistake != Mistake.CONE_NEVER_SENT && found.explains == null && shadingVerdict[Check.CONE].isRight())
                    )
            in FORM -> shadingVerdict[Check.ATTENUATION_FORM]?.error != null
            in K -> shading.any { it.mistake in SPOILS_K || isUnknownLaw(it, found) }
            else -> false
        }

    /** Whether [other] says of all the lights of [found] that they fade in a way that no K describes, or that their vectors are another's. */
    private fun isUnknownLaw(
        other: Found,
        found: Found,
    ) = found.where.split(" and ").all { it in lights(other) } &&
        when (other.mistake) {
            Mistake.LATER_LIGHTS_FIRST_COSINE -> true
            Mistake.UNKNOWN -> other.explains.orEmpty().contains(found.mistake.check)
            else -> false
        }

    /** Whether [other] says that the light of [found], of whose cone no numbers were found, has one in a form without a name. */
    private fun isUnknownCone(
        other: Found,
        found: Found,
    ) = found.mistake == Mistake.CONE_NEVER_SENT && other.mistake == Mistake.UNKNOWN && found.where in lights(other) &&
        (shadingVerdict[Check.CONE]?.error ?: 0.0) >= 1

    /** Round angles among the numbers sent tell a cosine of a cosine from a cone turned inside out. */
    private fun breaksTie(found: Found): Boolean =
        found.mistake == Mistake.COSINE_OF_COSINE && seen.any { it.mistake == Mistake.CONE_INSIDE_OUT }

    private fun Measured?.isRight() = this?.error.let { it != null && it <= RIGHT }

    private companion object {
        const val RIGHT = 0.02
        val DIRECTION = setOf(Mistake.SPOT_DIRECTION_WORLD, Mistake.SPOT_DIRECTION_LOCAL, Mistake.SPOT_DIRECTION_SIGN)
        val CONE = VerdictTraces.CONES

        /** These the study names by the curve. */
        val FORM = setOf(Mistake.ATTENUATION_MISSING, Mistake.ATTENUATION_LINEAR)
        val K = setOf(Mistake.ATTENUATION_OTHER_K, Mistake.ATTENUATION_ONE_K, Mistake.ATTENUATION_LAST_K)

        /** With a curve of another form the numbers sent for it mean nothing, nor with a distance that is always 1. */
        val SPOILS_K =
            FORM + setOf(Mistake.NORMALIZED_IN_VERTEX_SHADER, Mistake.TO_LIGHT_NOT_NORMALIZED, Mistake.DIFFUSE_MISSING)
    }
}

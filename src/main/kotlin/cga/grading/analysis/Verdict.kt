package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.scene.SceneVerdict
import cga.grading.study.ShaderStudy

/**
 * One verdict from two witnesses: the study, which knows what the shaders compute, and the scene, which knows what happens over time. Where
 * both see the traces of one mistake, the one that sees its cause is believed.
 */
internal class Verdict private constructor(
    val checks: List<Measured>,
    val mistakes: List<Found>,
) {
    companion object {
        /** Attenuation that is wrong in the shader makes the numbers sent for it meaningless. */
        private val WRONG_FORM =
            setOf(Mistake.ATTENUATION_MISSING, Mistake.ATTENUATION_LINEAR, Mistake.ATTENUATION_ON_DIFFUSE_ONLY)
        private val K_SENT =
            setOf(Mistake.ATTENUATION_MISSING, Mistake.ATTENUATION_OTHER_K, Mistake.ATTENUATION_ONE_K, Mistake.ATTENUATION_LAST_K)

        /** The scene follows these over all frames; a single frame can mislead. */
        private val SCENE_KNOWS = setOf(Mistake.SPOT_DIRECTION_WORLD, Mistake.SPOT_DIRECTION_LOCAL, Mistake.SPOT_DIRECTION_SIGN)
        private val CONE = Mistake.entries.filter { it.check == Check.CONE }.toSet()
        private val EMISSION = setOf(Mistake.EMISSION_COLOR_IGNORED, Mistake.EMISSION_MULTIPLIED, Mistake.EMISSION_MISSING)

        fun of(study: ShaderStudy, scene: SceneVerdict): Verdict {
            val fromScene = fromScene(study.mistakes, scene.mistakes)
            val fromStudy = fromStudy(study.mistakes, scene.mistakes)
            val mistakes = (fromScene + fromStudy).distinctBy { it.mistake }
            return Verdict(Check.entries.map { check(it, study, scene, mistakes) }, mistakes)
        }

        private fun fromScene(study: List<Found>, scene: List<Found>): List<Found> {
            val seen = study.map { it.mistake }.toSet()
            return scene.filterNot { found ->
                (found.mistake in CONE && seen.any { it in CONE } && !breaksTie(found, study)) ||
                    (found.mistake in K_SENT && seen.any { it in WRONG_FORM }) ||
                    (found.mistake in EMISSION && seen.any { it in EMISSION })
            }
        }

        private fun fromStudy(study: List<Found>, scene: List<Found>): List<Found> =
            study.filterNot { found ->
                found.mistake in SCENE_KNOWS ||
                    (found.mistake in CONE && scene.any { it.mistake in CONE && breaksTie(it, study) })
            }

        /** Round angles among the numbers sent tell a cosine of a cosine from a cone turned inside out. */
        private fun breaksTie(scene: Found, study: List<Found>): Boolean =
            scene.mistake == Mistake.COSINE_OF_COSINE && study.any { it.mistake == Mistake.CONE_INSIDE_OUT }

        /** The larger of the two errors; the scene's for what only it can see. */
        private fun check(check: Check, study: ShaderStudy, scene: SceneVerdict, mistakes: List<Found>): Measured {
            val shading = study.checks.firstOrNull { it.check == check }
            val staging = scene[check]?.takeUnless {
                check == Check.CONE && shading?.error != null &&
                    mistakes.none { it.mistake.check == Check.CONE }
            }
            val both = listOfNotNull(shading, staging)
            return both.filter { it.error != null }.maxByOrNull { it.error ?: 0.0 }
                ?: both.firstOrNull()
                ?: Measured(check, null, "not measured")
        }
    }
}

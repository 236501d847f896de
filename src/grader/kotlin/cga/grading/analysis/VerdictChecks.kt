package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.sheet4.scene.SceneVerdict

/**
 * The checks of two witnesses in one list.
 *
 * @param known the mistakes that are believed.
 */
internal class VerdictChecks(
    private val shading: ShadingVerdict,
    private val scene: SceneVerdict,
    private val known: List<Found>,
) {
    fun all(): List<Measured> = Check.entries.map(::merged)

    private fun merged(check: Check): Measured {
        if (scene.isReplaced) return scene[check] ?: Measured(check, null, "A shader was refused, so nothing of this can be seen.")
        val shaders = shaders(check)
        val staging = staging(check, shaders)
        val worse = listOfNotNull(staging, shaders).filter { it.error != null }.maxByOrNull { it.error ?: 0.0 }
        return worse ?: absent(check) ?: staging ?: shaders ?: Measured(check, null, "This could not be measured.")
    }

    /** What the study says, unless it says so because of a mistake that is not believed. */
    private fun shaders(check: Check): Measured? {
        val named = shading.mistakes.filter { it.mistake.check == check && it.mistake != Mistake.UNKNOWN }
        val isVoid = named.isNotEmpty() && named.none { found -> known.any { it.mistake == found.mistake } }
        return shading[check]?.takeUnless { isVoid }
    }

    /** What the scene says, unless the shaders show better. */
    private fun staging(
        check: Check,
        shaders: Measured?,
    ): Measured? {
        val staging = scene[check] ?: return null
        val isShaded = shaders?.error != null
        // What never shines may be computed right all the same.
        if (isShaded && !staging.found) return null
        // The numbers of a cone are odd, and what it makes of them is right.
        return staging.takeUnless {
            check == Check.CONE && isShaded &&
                known.none { it.mistake.check == Check.CONE || VerdictTraces.isLossOfCone(it) }
        }
    }

    /** What cannot be measured because there is nothing. */
    private fun absent(check: Check): Measured? {
        val without =
            when (check) {
                Check.DIFFUSE, Check.SPECULAR, Check.NORMALS, Check.INTERPOLATION, Check.MATERIAL, Check.ATTENUATION_FORM,
                Check.HALF_VECTOR,
                ->
                    listOf(Mistake.LIGHT_MISSING, Mistake.SPOT_MISSING, Mistake.MORE_LIGHTS_MISSING)
                Check.CONE_SPECULAR -> listOf(Mistake.SPOT_MISSING)
                Check.MORE_LIGHTS_SHADING -> listOf(Mistake.MORE_LIGHTS_MISSING)
                else -> return null
            }
        if (without.any { mistake -> known.none { it.mistake == mistake } }) return null
        return Measured(check, 1.0, "There is no light that this could be seen by.", found = false)
    }
}

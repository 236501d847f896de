package cga.grading.study

import org.joml.Vector3d
import kotlin.math.abs

/** Whether another light shines in the colour of one that is understood: what arrives is more than that one gives. */
internal object LentColor {
    /** The names of those [lights] in whose colour more shines at [samples] than they explain; none where a light has a cone. */
    fun among(
        lights: List<LightModel>,
        roles: TextureRoles,
        samples: List<Sample>,
    ): Set<String> =
        if (lights.any { it.cone != null }) {
            emptySet()
        } else {
            lights.filter { isLent(it, roles, samples) }.map { it.name }.toSet()
        }

    private fun isLent(
        light: LightModel,
        roles: TextureRoles,
        samples: List<Sample>,
    ): Boolean {
        val law = light.attenuation ?: return false
        val placement = light.placement ?: return false
        if (!isUnderstood(light) || law.error > AttenuationFit.ACCEPTED || law.from != null || roles.diffuse == null) return false
        val shades = light.probe.shade(samples, roles.onlyDiffuse)
        val largest = shades.filter { it.isFinite() }.maxOrNull() ?: return false
        val more =
            samples.indices.count { i ->
                val toLight = placement.toLight(samples[i].position)
                val normal = placement.normalOf(samples[i].normal).normalize()
                val cosine = toLight.normalize(Vector3d()).dot(normal).coerceAtLeast(0.0)
                shades[i] - cosine * law.factor(toLight.length()) > UNEXPLAINED * largest
            }
        return more >= FEW
    }

    private fun isUnderstood(light: LightModel) =
        light.cone == null && !light.unclamped && light.cosineError < TOLERATED && abs(light.floor) < TOLERATED &&
            abs(light.normalLength - 1) < TOLERATED

    /** Relative to the brightest: a hundred times what the laws leave. */
    private const val UNEXPLAINED = 0.02
    private const val TOLERATED = 5e-3
    private const val FEW = 4
}

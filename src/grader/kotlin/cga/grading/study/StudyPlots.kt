package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Plot

/** The curves that show what shaders do with a light. */
internal object StudyPlots {
    /** Attenuation over distance and, for spotlights, intensity over the angle; of a few lights. */
    fun of(studies: Collection<ProgramStudy>): List<Plot> {
        val lights = studies.flatMap { it.shining }.distinctBy { it.name }
        return lights.take(MOST).mapNotNull(::attenuation) + lights.mapNotNull(::cone)
    }

    private fun attenuation(light: LightModel): Plot? {
        val fit = light.attenuation ?: return null
        val expected = DoubleArray(fit.distances.size) {
            fit.distances[it].let { d ->
                1 / (fit.k.x() + fit.k.y() * d + fit.k.z() * d * d)
            }
        }
        return Plot(Check.ATTENUATION_FORM, light.name, "d", "F", fit.distances, fit.strengths, expected)
    }

    private fun cone(light: LightModel): Plot? {
        val cone = light.cone ?: return null
        val last = cone.thetas.indexOfFirst { it > Math.PI / 2 }
        val thetas = DoubleArray(last) { Math.toDegrees(cone.thetas[it]) }
        val (near, far) = listOf(cone.cosInner, cone.cosOuter).sortedDescending().let { it[0] to it[1] }
        val expected = DoubleArray(last) { ((Math.cos(cone.thetas[it]) - far) / (near - far)).coerceIn(0.0, 1.0) }
        return Plot(Check.CONE, light.name, "θ", "I", thetas, cone.intensities.copyOf(last), expected)
    }

    private const val MOST = 8
}

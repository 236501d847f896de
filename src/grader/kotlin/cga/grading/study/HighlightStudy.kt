package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4
import org.lwjgl.opengl.GL33C.GL_INT
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.max
import kotlin.random.Random

/** Measures the specular term of one placed light. */
internal class HighlightStudy(
    private val probe: LightProbe,
    private val roles: TextureRoles,
    private val amplitudes: Amplitudes,
    private val attenuation: AttenuationFit,
    private val cone: ConeFit?,
    private val inside: List<Vector3dc>,
    private val random: Random,
) {
    private val placement = amplitudes.placement

    /** The highlight; null where there is none. */
    fun highlight(): HighlightModel? {
        if (roles.specular == null) return null
        val fit = HighlightFit.of(probe, placement, inside, roles.onlySpecular) ?: return null
        val limits = limits(fit)
        // The power 0 is the same of any vector.
        if (fit.lobe == Lobe.BLINN && fit.exponent > FLAT && limits.best > SOUND) {
            // At one point the length of a half vector is a factor like any other; from point to point it changes.
            val long = HighlightFit(Lobe.BLINN_LONG, fit.eye, fit.lightReversed, fit.exponent, fit.error, fit.unclamped)
            val longLimits = limits(long)
            if (longLimits.best < limits.best / 4) return HighlightModel(long, longLimits, exponentSlot(long))
        }
        return HighlightModel(fit, limits, exponentSlot(fit))
    }

    /** The normal for which the highlight at [p] is brightest. */
    private fun centre(
        p: Vector3dc,
        fit: HighlightFit,
    ): Vector3d {
        val l = placement.toLight(p).normalize()
        val eye = HighlightFit.toEye(fit.eye, probe.box.spaces, placement, p) ?: placement.toCamera(p)
        return (if (fit.lightReversed) l.negate() else l).add(eye.normalize()).normalize()
    }

    /** The number sent that changes how fast the highlight falls off: one by itself, or else one of a vector. */
    private fun exponentSlot(fit: HighlightFit): ExponentSlot? {
        val samples =
            inside.flatMap { p ->
                val h = centre(p, fit)
                listOf(0.02, 0.2).map { Sample(p, placement.normalFor(Directions.around(h, it, 1.0))) }
            }

        fun falloff(changed: Map<String, FloatArray>): DoubleArray {
            val s = probe.shade(samples, roles.onlySpecular, changed)
            return DoubleArray(inside.size) { s[2 * it + 1] / s[2 * it] }
        }
        val usual = falloff(emptyMap())

        fun isFollowed(
            slot: ActiveUniform,
            component: Int,
        ): Boolean {
            val numbers = probe.box.values[slot.name] ?: FloatArray(slot.components) { 1f }
            val more = numbers.clone().also { it[component] = it[component] * 1.3f + 0.5f }
            val changed = falloff(mapOf(slot.name to more))
            if (usual.indices.none { abs(changed[it] - usual[it]) > 1e-3 * abs(usual[it]) && changed[it].isFinite() }) return false
            // Another exponent is the same power of what there was everywhere; another place of the light is not.
            val powers = usual.indices.map { ln(changed[it]) / ln(usual[it]) }
            return slot.components == 1 || powers.all { abs(it - powers[0]) < 1e-2 * abs(powers[0]) }
        }
        val uniforms = probe.box.program.uniforms
        // A small whole number is a count of lights or an index: not to be driven out of its array.
        val single = uniforms.filter { it.type == GL_FLOAT || (it.type == GL_INT && (probe.box.values[it.name]?.firstOrNull() ?: 1f) >= 8) }
        return (single + uniforms.filter { it.type in VECTORS }).firstNotNullOfOrNull { slot ->
            (0 until slot.components).firstOrNull { isFollowed(slot, it) }?.let { ExponentSlot(slot.name, it) }
        }
    }

    /** Compares the strength of the highlight with that of the diffuse term inside and outside of the cone, near and far. */
    private fun limits(fit: HighlightFit): HighlightLimits {
        val points =
            List(STRENGTHS) {
                val widest = cone?.let { (it.outer * 1.5).coerceIn(0.02, PI) } ?: 0.0
                val direction = if (cone ==
                    null
                ) {
                    Directions.random(random)
                } else {
                    Directions.around(cone.axis, random.nextDouble() * widest, random.nextDouble(2 * PI))
                }
                val d = exp(random.nextDouble(-0.7, 2.0))
                StrengthPoint(placement.at(Vector3d(direction).mul(d)), d, if (cone == null) 1.0 else cone.axis.dot(direction))
            }
        // Beside the very middle, where any power of the cosine is 1.
        val samples = points.map { p -> Sample(p.position, placement.normalFor(Directions.around(centre(p.position, fit), BESIDE, 1.0))) }
        val shades = probe.shade(samples, roles.onlySpecular)
        val strengths =
            DoubleArray(points.size) { i ->
                val eye =
                    HighlightFit.toEye(fit.eye, probe.box.spaces, placement, points[i].position) ?: placement.toCamera(points[i].position)
                val n = placement.normalOf(samples[i].normal).normalize()
                val power = fit.value(fit.cosine(n, placement.toLight(points[i].position), eye))
                if (power > FAINT) shades[i] / power else Double.NaN
            }
        val diffuse = amplitudes.at(points.map { it.position })
        val f = DoubleArray(points.size) {
            attenuation.factor(points[it].distance) *
                attenuation.let { a -> if (a.growing) 1 / points[it].distance else 1.0 }
        }
        val cones = DoubleArray(points.size) { if (cone == null) 1.0 else diffuse[it] / attenuation.factor(points[it].distance) }
        return HighlightLimits(
            all = misfit(strengths) { f[it] * cones[it] },
            coneOnly = misfit(strengths) { cones[it] },
            attenuationOnly = misfit(strengths) { f[it] },
            nothing = misfit(strengths) { 1.0 },
        )
    }

    /** How badly [expected] times the best constant describes [strengths]. */
    private fun misfit(
        strengths: DoubleArray,
        expected: (Int) -> Double,
    ): Double {
        var product = 0.0
        var square = 0.0
        for (i in strengths.indices) {
            if (!strengths[i].isFinite() || !expected(i).isFinite()) continue
            product += strengths[i] * expected(i)
            square += expected(i) * expected(i)
        }
        val scale = if (square > 0) product / square else 0.0
        var difference = 0.0
        var sum = 0.0
        for (i in strengths.indices) {
            if (!strengths[i].isFinite() || !expected(i).isFinite()) continue
            difference += abs(strengths[i] - scale * expected(i))
            sum += max(abs(strengths[i]), abs(scale * expected(i)))
        }
        return if (sum > 0) difference / sum else 1.0
    }

    private companion object {
        val VECTORS = setOf(GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4)
        const val STRENGTHS = 120
        const val BESIDE = 0.02
        const val SOUND = 1e-3
        const val FAINT = 1e-20
        const val FLAT = 1e-3
    }
}

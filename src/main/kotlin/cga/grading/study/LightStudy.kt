package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_INT
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.max
import kotlin.random.Random

/** Measures one light, step by step: where it is, its distance law, its cone, its highlight. */
internal class LightStudy(
    private val search: LightSearch,
    private val roles: TextureRoles,
) {
    private val random = Random(8)

    /** What the light of [probe] does; null where it shines on nothing that was looked at. */
    fun of(probe: LightProbe): LightModel? {
        val texels = if (roles.diffuse != null) roles.onlyDiffuse else probe.box.program.samplers.associate { it.name to 1.0 }
        val lit = search.litPoints(probe, texels)
        if (lit.isEmpty()) return null
        val placement = search.place(probe, lit, texels)?.takeIf { it.error < Placement.ACCEPTED * 5 }
        val cosine = placement?.let { CosineTest.of(probe, it, lit, texels) }
        if (placement == null || cosine == null || cosine.error > SUSPECT) {
            val shared = if (roles.diffuse == null) emptyList() else SharedColor.of(probe, lit, search.hints, texels)
            if (placement == null || cosine == null || shared.isNotEmpty()) {
                return LightModel(probe, null, false, 1.0, 1.0, 0.0, null, null, null, null, null, shared = shared)
            }
        }
        val amplitudes = Amplitudes(probe, placement, texels, cosine.unclamped)
        val seen = ConeFit.of(
            amplitudes,
            lit,
            search.axes
                .flatMap {
                    listOf(it, Vector3d(it).negate())
                }.map { placement.directionFromView(it).normalize() },
        )
        val straight = AttenuationFit.of(amplitudes, seen?.axis)
        val elsewhere = if (straight.error > AttenuationFit.ACCEPTED) AttenuationFit.fromElsewhere(amplitudes, search.hints) else null
        val attenuation = elsewhere ?: straight
        // Around a place that distances are not measured from, a light without a cone is uneven, too.
        val cone = if (elsewhere == null) seen else null
        val inside = inside(placement, cone)
        return LightModel(
            probe = probe,
            placement = placement,
            unclamped = cosine.unclamped,
            normalLength = cosine.normalLength,
            cosineError = cosine.error,
            floor = cosine.floor,
            attenuation = attenuation,
            cone = cone,
            highlight = highlight(probe, placement, amplitudes, attenuation, cone, inside),
            diffuseInterpolation = InterpolationTest.of(probe, placement, inside, texels),
            otherDirection = elsewhere != null,
            specularInterpolation = if (roles.specular !=
                null
            ) {
                InterpolationTest.of(probe, placement, inside, roles.onlySpecular)
            } else {
                null
            },
        )
    }

    /** Points that the light shines on fully, in view space. */
    private fun inside(
        placement: Placement,
        cone: ConeFit?,
    ): List<Vector3d> {
        val widest = cone?.let { if (it.inner > 0.01) it.inner * 0.9 else it.outer * 0.3 } ?: 0.0
        return List(INSIDE) {
            val direction = if (cone ==
                null
            ) {
                Directions.random(random)
            } else {
                Directions.around(cone.axis, random.nextDouble() * widest, random.nextDouble(2 * PI))
            }
            placement.at(direction.mul(exp(random.nextDouble(-0.7, 1.4))))
        }
    }

    private fun highlight(
        probe: LightProbe,
        placement: Placement,
        amplitudes: Amplitudes,
        attenuation: AttenuationFit,
        cone: ConeFit?,
        inside: List<Vector3dc>,
    ): HighlightModel? {
        if (roles.specular == null) return null
        val fit = HighlightFit.of(probe, placement, inside, roles.onlySpecular) ?: return null
        val limits = limits(probe, placement, amplitudes, attenuation, cone, fit)
        if (fit.lobe == Lobe.BLINN && limits.best > SOUND) {
            // At one point the length of a half vector is a factor like any other; from point to point it changes.
            val long = HighlightFit(Lobe.BLINN_LONG, fit.eye, fit.lightReversed, fit.exponent, fit.error, fit.unclamped)
            val longLimits = limits(probe, placement, amplitudes, attenuation, cone, long)
            if (longLimits.best < limits.best / 4) return HighlightModel(long, longLimits, exponentSlot(probe, placement, inside, long))
        }
        return HighlightModel(fit, limits, exponentSlot(probe, placement, inside, fit))
    }

    /** The normal for which the highlight at [p] is brightest. */
    private fun centre(
        probe: LightProbe,
        placement: Placement,
        p: Vector3dc,
        fit: HighlightFit,
    ): Vector3d {
        val l = placement.toLight(p).normalize()
        val eye = HighlightFit.toEye(fit.eye, probe.box.spaces, placement, p) ?: placement.toCamera(p)
        return (if (fit.lightReversed) l.negate() else l).add(eye.normalize()).normalize()
    }

    /** The uniform number that changes how fast the highlight falls off. */
    private fun exponentSlot(
        probe: LightProbe,
        placement: Placement,
        inside: List<Vector3dc>,
        fit: HighlightFit,
    ): ActiveUniform? {
        val samples =
            inside.flatMap { p ->
                val h = centre(probe, placement, p, fit)
                listOf(0.02, 0.2).map { Sample(p, placement.normalFor(Directions.around(h, it, 1.0))) }
            }

        fun falloff(changed: Map<String, FloatArray>): DoubleArray {
            val s = probe.shade(samples, roles.onlySpecular, changed)
            return DoubleArray(inside.size) { s[2 * it + 1] / s[2 * it] }
        }
        val usual = falloff(emptyMap())
        return probe.box.program.uniforms.filter { it.type == GL_FLOAT || it.type == GL_INT }.firstOrNull { slot ->
            val value = probe.box.values[slot.name]?.firstOrNull() ?: 1f
            // A small whole number is a count of lights or an index: not to be driven out of its array.
            if (slot.type == GL_INT && value < 8) return@firstOrNull false
            val changed = falloff(mapOf(slot.name to floatArrayOf(value * 1.3f + 0.5f)))
            usual.indices.any { abs(changed[it] - usual[it]) > 1e-3 * abs(usual[it]) && changed[it].isFinite() }
        }
    }

    /** Compares the strength of the highlight with that of the diffuse term inside and outside of the cone, near and far. */
    private fun limits(
        probe: LightProbe,
        placement: Placement,
        amplitudes: Amplitudes,
        attenuation: AttenuationFit,
        cone: ConeFit?,
        fit: HighlightFit,
    ): HighlightLimits {
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
        val samples = points.map { p -> Sample(p.position, placement.normalFor(centre(probe, placement, p.position, fit))) }
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
        const val INSIDE = 24
        const val STRENGTHS = 120
        const val SOUND = 1e-3
        const val FAINT = 1e-20
        const val SUSPECT = 5e-3
    }
}

/** How the diffuse term of a placed light depends on the normal. */
internal class CosineTest(
    val unclamped: Boolean,
    val normalLength: Double,
    val error: Double,
    val floor: Double,
) {
    companion object {
        fun of(
            probe: LightProbe,
            placement: Placement,
            points: List<Vector3dc>,
            texels: Map<String, Double>,
        ): CosineTest {
            val random = Random(9)
            val sign = if (placement.isFlipped) -1.0 else 1.0
            val towards = points.map { p -> placement.normalFor(placement.toLight(p).normalize().mul(sign)) }
            val across = points.map { p ->
                placement.normalFor(Directions.around(placement.toLight(p).normalize(), PI / 2, random.nextDouble(2 * PI)))
            }
            val samples = points.indices.flatMap { i ->
                listOf(towards[i], Vector3d(towards[i]).negate(), across[i], Vector3d(towards[i]).mul(0.5)).map { Sample(points[i], it) }
            }
            val s = probe.shade(samples, texels)
            val full = points.indices.sumOf { s[4 * it] - s[4 * it + 2] }
            val away = points.indices.sumOf { s[4 * it + 1] - s[4 * it + 2] }
            val floor = points.indices.sumOf { s[4 * it + 2] }
            val shorter = points.indices.sumOf { s[4 * it + 3] - s[4 * it + 2] }
            val unclamped = away < -0.05 * full
            val error = error(probe, placement, points, texels, unclamped, sign, s)
            return CosineTest(unclamped, shorter / full, error, floor / full)
        }

        private fun error(
            probe: LightProbe,
            placement: Placement,
            points: List<Vector3dc>,
            texels: Map<String, Double>,
            unclamped: Boolean,
            sign: Double,
            s: DoubleArray,
        ): Double {
            val random = Random(10)
            val normals = points.map { List(NORMALS) { Directions.random(random) } }
            val values = probe.shade(points.indices.flatMap { i -> normals[i].map { Sample(points[i], it) } }, texels)
            var difference = 0.0
            var sum = 0.0
            for (i in points.indices) {
                val l = placement.toLight(points[i]).normalize().mul(sign)
                for (j in 0 until NORMALS) {
                    val cosine = placement.normalOf(normals[i][j]).dot(l)
                    val expected = (s[4 * i] - s[4 * i + 2]) * if (unclamped) cosine else max(cosine, 0.0)
                    val value = values[NORMALS * i + j] - s[4 * i + 2]
                    if (!value.isFinite()) continue
                    difference += abs(value - expected)
                    sum += max(abs(value), abs(expected))
                }
            }
            return if (sum > 0) difference / sum else 1.0
        }

        private const val NORMALS = 12
    }
}

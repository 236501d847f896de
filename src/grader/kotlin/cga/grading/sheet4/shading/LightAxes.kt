package cga.grading.sheet4.shading

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.reading.Blend
import cga.grading.reading.Blends
import cga.grading.reading.Clamp
import cga.grading.reading.Factor
import cga.grading.reading.Falloff
import cga.grading.reading.Interpolation
import cga.grading.reading.KnownVector
import cga.grading.reading.LightReading
import cga.grading.reading.Lobe
import cga.grading.reading.ProgramReading
import cga.grading.reading.ShaderLine
import cga.grading.reading.Space
import cga.grading.reading.Term
import cga.grading.reading.ToPoint
import cga.grading.reading.all
import cga.grading.reading.inView
import cga.reader.shader.Source
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Vector3d
import kotlin.math.max
import kotlin.math.sqrt

/** The sheet's factors of one light, each compared with what the shader has: cos α, cos β, F and I. */
internal class LightAxes(
    private val reading: ProgramReading,
    private val light: LightReading,
    private val others: List<LightReading>,
    private val interpolation: Interpolation,
) {
    private val found = ArrayList<Deviation>()
    private val cosines = light.diffuse.flatMap { it.factors.filterIsInstance<Factor.Cosine>() }
    private val highlights = light.specular.flatMap { it.factors.filterIsInstance<Factor.Highlight>() }

    /** Whether vectors to the light are of length 1 before they are interpolated. */
    private var isEarly = false

    /** What is wrong with this light. */
    fun deviations(): List<Deviation> {
        cosines.forEach(::cosine)
        highlights.forEach(::highlight)
        if (light.sharesColor) add(Mistake.LATER_LIGHTS_FIRST_COLOR, light.terms.firstOrNull()?.factors?.firstOrNull()?.line)
        fade()
        cone()
        unknown()
        return found.distinctBy { listOf(it.mistake, it.check, it.text) }
    }

    private fun add(mistake: Mistake, line: ShaderLine?, error: Double = 1.0, check: Check = mistake.check, text: String = "") {
        found += Deviation(mistake, light.name, error.coerceAtMost(1.0), line, check, text)
    }

    private fun cosine(factor: Factor.Cosine) {
        way(factor.light.way, factor.line)
        normal(factor.normal.vector, factor.light.way.space, factor.line)
        if (factor.light.sign < 0) add(Mistake.LIGHT_VECTOR_SIGN, factor.line)
        if (!factor.light.isUnit) add(Mistake.TO_LIGHT_NOT_NORMALIZED, factor.line)
        when (factor.clamp) {
            Clamp.ZERO, Clamp.ZERO_TO_ONE -> Unit
            Clamp.NONE -> if (!isGated(factor)) add(Mistake.CLAMP_MISSING, factor.line, difference(factor))
            Clamp.ABSOLUTE -> add(Mistake.UNKNOWN, factor.line, check = Check.DIFFUSE, text = "absolute-cosine")
        }
        interpolation.of(factor)?.let { blends(it, factor.line, factor.normal.isUnit) }
    }

    /** Whether a branch leaves the term out where the cosine is negative. */
    private fun isGated(factor: Factor.Cosine): Boolean {
        val term = light.diffuse.find { factor in it.factors } ?: return false
        val dark = reading.samples.points.indices.filter { cosineAt(it, factor) < -1e-9 }
        return dark.isNotEmpty() && dark.none { term.runs[it] }
    }

    private fun cosineAt(i: Int, factor: Factor.Cosine): Double {
        val point = reading.samples.points[i]
        val n = factor.normal.vector.at(point.position, reading.finder.normalOf(point), true)
        val l = factor.light.way.vector
            .at(
                point.position,
                reading.finder.normalOf(point),
                true,
            ).mul(factor.light.way.sign * factor.light.sign)
        return n.dot(l)
    }

    /** What is not limited, relative to what should be there. */
    private fun difference(factor: Factor.Cosine): Double {
        val all = reading.samples.points.indices.map { cosineAt(it, factor) }
        return sqrt(all.sumOf { (it - max(it, 0.0)).let { d -> d * d } } / all.sumOf { max(it, 0.0).let { c -> c * c } })
    }

    /** The vector of another light is no vector of this one. */
    private fun way(way: ToPoint, line: ShaderLine) {
        if (isOwn(way)) return
        val other = others.find { it !== light && isSame(it.way, way) }
        add(
            if (other !=
                null
            ) {
                Mistake.LATER_LIGHTS_FIRST_COSINE
            } else {
                Mistake.UNKNOWN
            },
            line,
            check = Check.MORE_LIGHTS_SHADING,
            text = "another-way",
        )
    }

    /** Whether [way] leads from the surface in view space to where the light is in the world. */
    private fun isAcross(way: ToPoint): Boolean {
        val world = reading.spaces.view?.invert(Matrix4d())?.transformPosition(light.way.inView(reading.spaces)) ?: return false
        return way.space == Space.VIEW && !isOwn(way) && world.distance(way.place) < EXACT
    }

    private fun isOwn(way: ToPoint) = isSame(way, light.way)

    private fun isSame(a: ToPoint, b: ToPoint) = a.inView(reading.spaces).distance(b.inView(reading.spaces)) < 1e-4

    private fun normal(vector: KnownVector, space: Space, line: ShaderLine) {
        val error = error(vector, space) ?: return
        // Matrices that are sent are floats.
        if (error < EXACT) return
        // Where the normal and the vector to the eye are in one space, it is the vector to the light that is in another.
        val eyes = highlights.map { it.eye.way.space }.distinct().ifEmpty { listOf(Space.VIEW) }
        val isLightAlone = space !in eyes && eyes.any { (error(vector, it) ?: 1.0) < EXACT }
        add(if (isLightAlone) Mistake.TO_LIGHT_WORLD else Mistake.NORMAL_MATRIX, vector.line.takeIf { it.line > 0 } ?: line, error)
    }

    /** How far [vector] is from the normal in [space], both of length 1. */
    private fun error(vector: KnownVector, space: Space): Double? {
        val right = reading.spaces.all()[space]?.let { Matrix3d(it).normal() } ?: return null
        return reading.samples.points
            .map { point ->
                val n = reading.finder.normalOf(point)
                right.transform(Vector3d(n)).normalize().distance(vector.at(point.position, n, true))
            }.average()
    }

    private fun blends(blends: Blends, line: ShaderLine, isNormalUnit: Boolean) {
        if (blends.isPerVertex) return add(Mistake.UNKNOWN, line, check = Check.INTERPOLATION, text = "per-vertex")
        val early = setOf(Blend.EARLY, Blend.EARLY_ONLY)
        if (blends.light in early || blends.eye in early) {
            isEarly = isEarly || blends.light in early
            add(Mistake.NORMALIZED_IN_VERTEX_SHADER, line)
        }
        if (blends.normal == Blend.NEVER || blends.normal == Blend.EARLY_ONLY ||
            !isNormalUnit
        ) {
            add(Mistake.NORMAL_NOT_RENORMALIZED, line, 0.5)
        }
    }

    private fun highlight(factor: Factor.Highlight) {
        way(factor.light.way, factor.line)
        if (cosines.isEmpty()) normal(factor.normal.vector, factor.light.way.space, factor.line)
        // Where the vector to the light itself is the wrong way round that is said already.
        if (factor.eye.sign < 0 || factor.light.sign != light.sign) add(Mistake.VIEW_VECTOR_SIGN, factor.line)
        if (reading.factors.eyes.none {
                isSame(it, factor.eye.way)
            }
        ) {
            add(Mistake.UNKNOWN, factor.line, check = Check.SPECULAR, text = "eye-elsewhere")
        }
        when (factor.lobe) {
            Lobe.HALF -> if (!factor.light.isUnit ||
                !factor.eye.isUnit
            ) {
                add(Mistake.HALF_VECTOR_NOT_NORMALIZED, factor.line, text = "half-of-long-vectors")
            }
            Lobe.HALF_RAW, Lobe.HALF_MEAN -> add(Mistake.HALF_VECTOR_NOT_NORMALIZED, factor.line)
            Lobe.REFLECTED -> add(Mistake.PHONG_LEFT, factor.line)
        }
        if (!factor.isClamped) add(Mistake.SPECULAR_CLAMP_MISSING, factor.line)
        if (factor.exponentFrom == null || factor.exponentFrom.source is Source.Constant) add(Mistake.EXPONENT_FIXED, factor.line)
        interpolation.of(factor)?.let { blends(it, factor.line, factor.normal.isUnit) }
    }

    private fun fade() {
        val diffuse = light.diffuse.flatMap { it.factors.filterIsInstance<Factor.Fade>() }
        val specular = light.specular.flatMap { it.factors.filterIsInstance<Factor.Fade>() }
        val all = diffuse + specular
        val line = (cosines.firstOrNull()?.line ?: highlights.firstOrNull()?.line)
        if (all.isEmpty()) {
            val hasUnknown = light.terms.all { term -> term.factors.any { it is Factor.Unknown } }
            if (!hasUnknown && !isEarly) add(Mistake.ATTENUATION_MISSING, line)
            return
        }
        val isOnBoth = light.diffuse.isEmpty() || light.specular.isEmpty() || (diffuse.isNotEmpty() && specular.isNotEmpty())
        if (!isOnBoth) add(Mistake.ATTENUATION_ON_DIFFUSE_ONLY, all[0].line)
        for (fade in all.distinctBy { it.node.key }) law(fade)
        if (light.terms.any { term ->
                term.factors.count { it is Factor.Fade } > 1
            }
        ) {
            add(Mistake.UNKNOWN, all[0].line, check = Check.ATTENUATION_FORM, text = "fades-twice")
        }
    }

    private fun law(fade: Factor.Fade) {
        if (isAcross(fade.way)) {
            add(Mistake.TO_LIGHT_WORLD, fade.line)
        } else if (!isOwn(fade.way)) {
            val isEye = reading.factors.eyes.any { isSame(it, fade.way) }
            val check = if (light.cone != null) Check.ATTENUATION_SPOT else Check.ATTENUATION_FORM
            add(Mistake.UNKNOWN, fade.line, check = check, text = if (isEye) "fades-from-the-eye" else "fades-with-another-distance")
        }
        val size = fade.k.x() + fade.k.y() + fade.k.z()
        when {
            !fade.isDivided -> add(Mistake.UNKNOWN, fade.line, check = Check.ATTENUATION_FORM, text = "not-divided")
            fade.k.z() < 1e-6 * size -> add(Mistake.ATTENUATION_LINEAR, fade.line)
        }
    }

    private fun cone() {
        val cone = light.cone ?: return
        val isOnBoth =
            light.specular.isEmpty() || light.gate != null || light.specular.all { term -> term.factors.any { it is Factor.Cone } }
        if (!isOnBoth) add(Mistake.SPECULAR_NOT_CONED, cone.line)
        if (!isOwn(cone.way)) add(Mistake.UNKNOWN, cone.line, check = Check.CONE, text = "cone-of-another-way")
        when {
            cone.isLong -> add(Mistake.UNKNOWN, cone.line, check = Check.CONE, text = "cone-of-a-long-vector")
            cone.falloff == Falloff.HARD -> add(Mistake.CONE_HARD_EDGE, cone.line)
            cone.falloff != Falloff.LINEAR -> add(
                Mistake.UNKNOWN,
                cone.line,
                check = Check.CONE,
                text = "falloff-${cone.falloff.name.lowercase()}",
            )
            !cone.isLimitedAbove || !cone.isLimitedBelow -> add(Mistake.CONE_CLAMP_MISSING, cone.line)
        }
    }

    private fun unknown() {
        val diffuse = light.diffuse.flatMap(::unknowns)
        val specular = light.specular.flatMap(::unknowns)
        val rest = (light.terms - light.diffuse.toSet() - light.specular.toSet()).flatMap(::unknowns)
        for (factor in (diffuse + specular + rest).distinctBy { it.node.key }) {
            val inDiffuse = diffuse.any { it.node.key == factor.node.key }
            val inSpecular = specular.any { it.node.key == factor.node.key }
            val check = if (inDiffuse && inSpecular) {
                Check.ATTENUATION_FORM
            } else if (inSpecular) {
                Check.SPECULAR
            } else {
                Check.DIFFUSE
            }
            add(Mistake.UNKNOWN, factor.line, check = check, text = "unknown-factor")
        }
    }

    private fun unknowns(term: Term) = term.factors.filterIsInstance<Factor.Unknown>()

    private companion object {
        const val EXACT = 1e-4
    }
}

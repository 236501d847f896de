package cga.grading.study

import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedLight
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.acos

/** Where one number of a light comes from: a component of a uniform, or always the same. */
internal class NumberRef(
    private val name: String?,
    private val index: Int,
    private val constant: Double,
) {
    /** The number that [values] give. */
    fun of(values: Map<String, FloatArray>): Double = name?.let { values[it]?.getOrNull(index)?.toDouble() } ?: constant
}

/** Where a position or direction comes from. @param space the one that the uniform is in, null for a constant of the world. */
internal class VectorRef(
    private val name: String?,
    private val space: Space?,
    private val factor: Double,
    private val constant: Vector3dc,
) {
    fun position(
        values: Map<String, FloatArray>,
        view: Matrix4dc,
    ): Vector3d = raw(values).let { if (space == Space.VIEW) it else view.transformPosition(it) }

    fun direction(
        values: Map<String, FloatArray>,
        view: Matrix4dc,
    ): Vector3d = raw(values).let { if (space == Space.VIEW) it else view.transformDirection(it) }.normalize().mul(factor)

    private fun raw(values: Map<String, FloatArray>): Vector3d {
        val value = name?.let { values[it] } ?: return Vector3d(constant)
        return Vector3d(value[0].toDouble(), value[1].toDouble(), value[2].toDouble())
    }
}

/**
 * A light in terms of uniforms, so that it can be told for every draw without measuring again.
 *
 * @param scale what the colour is multiplied with: an intensity.
 */
internal class LightRefs(
    private val name: String,
    private val color: String,
    private val scale: Double,
    private val position: VectorRef,
    private val k: List<NumberRef>,
    private val cone: ConeRefs?,
) {
    /** The direction of a cone and what makes its edges. */
    internal class ConeRefs(
        val direction: VectorRef,
        val form: AngleForm,
        val inner: NumberRef,
        val outer: NumberRef,
        val isReversed: Boolean,
    )

    /** The light as a draw with the uniforms [values] takes it. */
    fun light(
        values: Map<String, FloatArray>,
        view: Matrix4dc,
    ): ObservedLight {
        val c = values[color] ?: FloatArray(3)
        return ObservedLight(
            name = name,
            position = position.position(values, view),
            color = Vector3d(c[0].toDouble(), c[1].toDouble(), c[2].toDouble()).mul(scale),
            k = Vector3d(k[0].of(values), k[1].of(values), k[2].of(values)),
            spot = cone?.let {
                ObservedCone(
                    it.direction.direction(values, view),
                    angle(it, it.inner, values),
                    angle(it, it.outer, values),
                )
            },
        )
    }

    private fun angle(
        cone: ConeRefs,
        number: NumberRef,
        values: Map<String, FloatArray>,
    ): Double {
        val cosine = cone.form.cosine(number.of(values)) * if (cone.isReversed) -1 else 1
        return if (abs(cosine) <= 1) acos(cosine) else Double.NaN
    }

    companion object {
        /** Finds the uniforms behind [light]; several lights where several share its colour, none where it could not be placed. */
        fun of(
            light: LightModel,
            study: ProgramStudy,
        ): List<LightRefs> {
            val finder = RefFinder(light.probe.slot.name, study)
            if (light.shared.isNotEmpty()) {
                return light.shared.mapIndexed { i, shared ->
                    val (k, scale) = finder.attenuation(shared.attenuation?.k ?: Vector3d(1.0, 0.0, 0.0))
                    LightRefs("${light.name} (${i + 1})", light.probe.slot.name, scale, finder.position(Vector3d(shared.view)), k, null)
                }
            }
            val placement = light.placement ?: return listOfNotNull(light.guess?.let { guessed(light, finder, it) })
            val law = light.attenuation?.k ?: Vector3d(1.0, 0.0, 0.0)
            // Vectors that were normalised too early are 1 long everywhere: what is seen is F(1), and that is a defect of its own.
            val (k, scale) = (if (LightDeviations.isAtLengthOne(light)) finder.sumOf(law.x())?.let { finder.attenuation(it) } else null)
                ?: finder.attenuation(law)
            val cone = light.cone?.let { finder.cone(it, placement.directionToView(it.axis)) }
            return listOf(LightRefs(light.name, light.probe.slot.name, scale, finder.position(placement.view), k, cone))
        }

        /** All that can be said of a light that is somewhere: nothing of its K. */
        private fun guessed(
            light: LightModel,
            finder: RefFinder,
            place: Vector3dc,
        ) = LightRefs(
            light.name, light.probe.slot.name, 1.0,
            finder.position(
                Vector3d(place),
            ),
            List(3) { NumberRef(null, 0, Double.NaN) }, null,
        )
    }
}

/** Looks for the uniforms whose values explain what was measured; of several with one value the one whose name is most like [color]'s. */
internal class RefFinder(
    private val color: String,
    private val study: ProgramStudy,
) {
    private val values = study.box.values
    private val view: Matrix4dc? = study.box.spaces.view
    private val slots =
        study.box.program.uniforms
            .filter { it.components <= 4 && !it.isSampler && it.name in values && it.name != color }
            .sortedByDescending { it.name.commonPrefixWith(color).length }

    fun position(measured: Vector3d): VectorRef {
        val tolerance = 1e-3 * (1 + measured.length())
        for ((slot, raw) in vectors()) {
            if (raw.distance(measured) < tolerance) return VectorRef(slot.name, Space.VIEW, 1.0, measured)
            val viewed = view?.transformPosition(raw, Vector3d()) ?: continue
            if (viewed.distance(measured) < tolerance) return VectorRef(slot.name, Space.WORLD, 1.0, measured)
        }
        turnedOnly(measured)?.let { return VectorRef(it.name, Space.WORLD, 1.0, measured) }
        return if (view ==
            null
        ) {
            VectorRef(null, Space.VIEW, 1.0, measured)
        } else {
            VectorRef(null, null, 1.0, view.invert(Matrix4d()).transformPosition(measured))
        }
    }

    /** The uniform that is at [measured] when it goes through the view matrix as a direction; null where one is there as a point. */
    fun turnedOnly(measured: Vector3dc): ActiveUniform? {
        val matrix = view ?: return null
        val tolerance = 1e-3 * (1 + measured.length())
        val (found, isPoint) =
            vectors()
                .partition { (_, raw) ->
                    raw.length() > tolerance &&
                        matrix.transformDirection(raw, Vector3d()).distance(measured) < tolerance
                }.let { (turned, others) ->
                    turned to
                        vectors().any { (_, raw) ->
                            raw.distance(measured) < tolerance ||
                                matrix.transformPosition(raw, Vector3d()).distance(measured) < tolerance
                        }
                }
        return if (isPoint) null else found.firstOrNull()?.first
    }

    fun cone(
        cone: ConeFit,
        axis: Vector3dc,
    ): LightRefs.ConeRefs {
        for (reversed in listOf(false, true)) {
            val sign = if (reversed) -1 else 1
            val words = ConeWords.of(
                sign * cone.cosInner,
                sign * cone.cosOuter,
                slots
                    .flatMap {
                        values.getValue(it.name).toList()
                    }.map { it.toDouble() },
            )
            if (words != null) return LightRefs.ConeRefs(direction(axis), words.form, number(words.full), number(words.dark), reversed)
        }
        return LightRefs.ConeRefs(
            direction(axis),
            AngleForm.COSINE,
            NumberRef(null, 0, cone.cosInner),
            NumberRef(null, 0, cone.cosOuter),
            false,
        )
    }

    /** K and the factor that the colour has beside: K is only known up to such a factor, and values that were sent settle it, then Table 1. */
    fun attenuation(k: Vector3dc): Pair<List<NumberRef>, Double> {
        val sent = slots.flatMap { slot -> values.getValue(slot.name).map { it.toDouble() } }.filter { it > 0 }.distinct()
        val first = (0..2).firstOrNull { k[it] > 0 } ?: return List(3) { NumberRef(null, 0, k[it]) } to 1.0
        val scales = listOf(1.0) + sent.map { it / k[first] }.filter { it in 1e-3..1e3 } + TABLE.map { it[first] / k[first] }
        val explained =
            scales.firstOrNull { scale ->
                (0..2).all { i -> k[i] == 0.0 || sent.any { isNear(it, scale * k[i]) } } &&
                    (scale == 1.0 || !(k.y() == 0.0 && k.z() == 0.0))
            }
                ?: scales.firstOrNull { scale -> TABLE.any { row -> (0..2).all { isNear(row[it], scale * k[it]) } } }
                ?: 1.0
        return List(3) { number(explained * k[it]) } to explained
    }

    /** The K among what was sent, or in Table 1, that adds up to [total]: 1/F at the distance 1. */
    fun sumOf(total: Double): Vector3dc? =
        (vectors().map { it.second } + TABLE.map { Vector3d(it[0], it[1], it[2]) }).firstOrNull {
            isNear(it.x + it.y + it.z, total) &&
                it.x >= 0 &&
                it.y >= 0 &&
                it.z >= 0
        }

    private fun direction(axis: Vector3dc): VectorRef {
        for ((slot, raw) in vectors()) {
            if (!(raw.length() > 0)) continue
            val d = Vector3d(raw).normalize()
            for (factor in listOf(1.0, -1.0)) {
                if (Vector3d(d).mul(factor).distance(axis) < 1e-3) return VectorRef(slot.name, Space.VIEW, factor, axis)
                val viewed = view?.transformDirection(d, Vector3d())?.normalize() ?: continue
                if (viewed.mul(factor).distance(axis) < 1e-3) return VectorRef(slot.name, Space.WORLD, factor, axis)
            }
        }
        return if (view ==
            null
        ) {
            VectorRef(null, Space.VIEW, 1.0, axis)
        } else {
            VectorRef(null, null, 1.0, view.invert(Matrix4d()).transformDirection(axis, Vector3d()))
        }
    }

    private fun number(value: Double): NumberRef {
        for (slot in slots) {
            val index = values.getValue(slot.name).indexOfFirst { isNear(it.toDouble(), value) }
            if (index >= 0 && value != 0.0) return NumberRef(slot.name, index, value)
        }
        return NumberRef(null, 0, value)
    }

    private fun vectors(): List<Pair<ActiveUniform, Vector3d>> =
        slots.filter { it.components in 3..4 }.map { slot ->
            slot to
                values.getValue(slot.name).let { Vector3d(it[0].toDouble(), it[1].toDouble(), it[2].toDouble()) }
        }

    private fun isNear(
        a: Double,
        b: Double,
    ) = abs(a - b) <= 2e-4 * abs(b)

    private companion object {
        /** Table 1 of the sheet: K of a point light and of a spotlight. */
        val TABLE = listOf(listOf(1.0, 0.5, 0.1), listOf(0.5, 0.05, 0.01))
    }
}

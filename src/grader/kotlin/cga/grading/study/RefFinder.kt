package cga.grading.study

import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs

/** Looks for the uniforms whose values explain what was measured of [light]; of several with one value the one whose name is most like its colour's. */
internal class RefFinder(
    private val light: LightModel,
    private val study: ProgramStudy,
) {
    private val color = light.probe.slot.name
    private val values = study.box.values
    private val view: Matrix4dc? = study.box.spaces.view
    private val slots =
        study.box.program.uniforms
            .filter { it.components <= 4 && !it.isSampler && it.name in values && it.name != color }
            .sortedByDescending { it.name.commonPrefixWith(color).length }

    fun position(measured: Vector3d): VectorRef {
        val tolerance = 1e-3 * (1 + measured.length())
        for (sent in vectors() + columns(TRANSLATION)) {
            if (sent.raw.distance(measured) < tolerance) return sent.ref(Space.VIEW, 1.0, measured)
            val viewed = view?.transformPosition(sent.raw, Vector3d()) ?: continue
            if (viewed.distance(measured) < tolerance) return sent.ref(Space.WORLD, 1.0, measured)
        }
        detour(measured)?.let { return VectorRef(it.name, Space.WORLD, 1.0, measured) }
        return if (view ==
            null
        ) {
            VectorRef(null, Space.VIEW, 1.0, measured)
        } else {
            VectorRef(null, null, 1.0, view.invert(Matrix4d()).transformPosition(measured))
        }
    }

    /** The uniform of a world position that one of the [Detours] brings to [measured] in view space; null where one is there as a point. */
    fun detour(measured: Vector3dc): ActiveUniform? {
        val tolerance = 1e-3 * (1 + measured.length())

        fun isThere(point: Vector3d) = point.distance(measured) < tolerance
        val sent = vectors()
        if (sent.any { isThere(it.raw) || view?.transformPosition(it.raw, Vector3d())?.let(::isThere) == true }) return null
        return sent
            .firstOrNull { one ->
                val way = if (one.raw.length() > tolerance) Detours.of(study.box.spaces, one.raw).indexOfFirst(::isThere) else -1
                way >= 0 && isDetourElsewhere(one, way)
            }?.slot
    }

    /** Whether the light of another object's draw has come the same [way]: the motorcycle's matrix is right where it is not every object's own. */
    private fun isDetourElsewhere(
        sent: Sent,
        way: Int,
    ): Boolean {
        val other = study.elsewhere ?: return true
        val place = PlaceMeter.of(light, study)?.place(other.values, other.spaces) ?: return true
        val raw = other.values[sent.slot.name]?.let { VectorRef.vector(it, 0) } ?: return true
        val expected = Detours.of(other.spaces, raw).getOrNull(way) ?: return true
        return expected.distance(place) < 1e-2 * (1 + place.length())
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

    /**
     * K and the factor that the colour has beside: a light is K only up to such a factor, for how bright it is is free. So a row of Table 1
     * settles it where K is a multiple of one, whatever was sent for it; values that were sent do where it is of none.
     */
    fun attenuation(k: Vector3dc): Pair<List<NumberRef>, Double> {
        val sent = slots.flatMap { slot -> values.getValue(slot.name).map { it.toDouble() } }.filter { it > 0 }.distinct()
        val first = (0..2).firstOrNull { k[it] > 0 } ?: return List(3) { NumberRef(null, 0, k[it]) } to 1.0
        val scales = listOf(1.0) + TABLE.map { it[first] / k[first] } + sent.map { it / k[first] }.filter { it in 1e-3..1e3 }

        fun areSent(scale: Double) = (0..2).all { i -> k[i] == 0.0 || sent.any { isNear(it, scale * k[i]) } }
        val explained =
            scales.firstOrNull { scale -> TABLE.any { row -> (0..2).all { isNear(row[it], scale * k[it]) } } }
                ?: scales.firstOrNull { scale -> areSent(scale) && (scale == 1.0 || !(k.y() == 0.0 && k.z() == 0.0)) }
                ?: 1.0
        val each = { part: Double -> if (areSent(explained)) number(part) else NumberRef(null, 0, part) }
        return (together(k, explained) ?: List(3) { each(explained * k[it]) }) to explained
    }

    /**
     * All three numbers of [k] times [scale] in one uniform; null where none holds them. One number alone may happen to be that of a colour,
     * and would change with it.
     */
    private fun together(k: Vector3dc, scale: Double): List<NumberRef>? {
        val holder = slots.filter { it.components >= 3 }.find { slot ->
            val numbers = values.getValue(slot.name)
            (0..2).all { isNear(numbers[it].toDouble(), scale * k[it]) }
        }
        return holder?.let { List(3) { i -> NumberRef(it.name, i, scale * k[i]) } }
    }

    /** The K among what was sent, or in Table 1, that adds up to [total]: 1/F at the distance 1. */
    fun sumOf(total: Double): Vector3dc? =
        (vectors().map { it.raw } + TABLE.map { Vector3d(it[0], it[1], it[2]) }).firstOrNull {
            isNear(it.x + it.y + it.z, total) &&
                it.x >= 0 &&
                it.y >= 0 &&
                it.z >= 0
        }

    /** How long the vectors are that point along [axis] in view space, or against it; those of length 1 left out. */
    fun lengthsAlong(axis: Vector3dc): List<Double> =
        aimable().filter { aim(it, axis) != null }.map { it.raw.length() }.filter { abs(it - 1) > 1e-3 }.distinct()

    private fun aimable(): List<Sent> = vectors() + columns(*AXES)

    /** The space and the sign with which [sent] is [axis], but for its length; null where it is not. */
    private fun aim(
        sent: Sent,
        axis: Vector3dc,
    ): Pair<Space, Double>? {
        if (!(sent.raw.length() > 0)) return null
        val d = Vector3d(sent.raw).normalize()
        val viewed = view?.transformDirection(d, Vector3d())?.normalize()
        for (factor in listOf(1.0, -1.0)) {
            if (Vector3d(d).mul(factor).distance(axis) < 1e-3) return Space.VIEW to factor
            if (viewed != null && Vector3d(viewed).mul(factor).distance(axis) < 1e-3) return Space.WORLD to factor
        }
        return null
    }

    private fun direction(axis: Vector3dc): VectorRef {
        for (sent in aimable()) aim(sent, axis)?.let { (space, factor) -> return sent.ref(space, factor, axis) }
        return if (view ==
            null
        ) {
            VectorRef(null, Space.VIEW, 1.0, axis)
        } else {
            VectorRef(null, null, 1.0, view.invert(Matrix4d()).transformDirection(axis, Vector3d()))
        }
    }

    /** The number sent that is nearest to [value]: the cosine of a narrow cone is nearly the 1 of something else. */
    private fun number(value: Double): NumberRef {
        val sent = slots.flatMap { slot -> values.getValue(slot.name).mapIndexed { i, it -> Triple(slot.name, i, it.toDouble()) } }
        val near = sent.filter { (_, _, number) -> isNear(number, value) }.minByOrNull { (_, _, number) -> abs(number - value) }
        return if (near == null || value == 0.0) NumberRef(null, 0, value) else NumberRef(near.first, near.second, value)
    }

    /** Three numbers of a uniform, from number [first] on. */
    private class Sent(
        val slot: ActiveUniform,
        val first: Int,
        val raw: Vector3d,
    ) {
        fun ref(
            space: Space,
            factor: Double,
            measured: Vector3dc,
        ) = VectorRef(slot.name, space, factor, measured, first)
    }

    private fun vectors(): List<Sent> =
        slots.filter { it.components in 3..4 }.map { Sent(it, 0, VectorRef.vector(values.getValue(it.name), 0)) }

    /** The columns of matrices that begin with the numbers [first]: a light may be sent by its matrix. */
    private fun columns(vararg first: Int): List<Sent> =
        study.box.program.matrices.filter { it !in study.formula.product && it in values }.flatMap { name ->
            val slot = study.box.program.uniforms.single { it.name == name }
            first.map { Sent(slot, it, VectorRef.vector(values.getValue(name), it)) }
        }

    private fun isNear(
        a: Double,
        b: Double,
    ) = abs(a - b) <= 2e-4 * abs(b)

    private companion object {
        /** Where the columns of a 4 x 4 matrix begin: those of the axes, and that of the translation. */
        val AXES = intArrayOf(0, 4, 8)
        const val TRANSLATION = 12

        /** Table 1 of the sheet: K of a point light and of a spotlight. */
        val TABLE = listOf(listOf(1.0, 0.5, 0.1), listOf(0.5, 0.05, 0.01))
    }
}

package cga.grading.study

import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sign

/** A point of a surface in view space with its normal, as a correct vertex shader would have them. The normal may have any length. */
internal class Sample(
    val position: Vector3dc,
    val normal: Vector3dc,
)

/** Uniform values and texture colours that differ from the draw's own. Immutable. */
internal class Setting(
    val values: Map<String, FloatArray> = emptyMap(),
    val texels: Map<String, FloatArray> = emptyMap(),
) {
    /** This with the uniform [name] at [value]. */
    fun with(
        name: String,
        vararg value: Double,
    ): Setting = Setting(values + (name to FloatArray(value.size) { value[it].toFloat() }), texels)

    /** This with all [names] at [level] in every component of theirs that is a colour. */
    fun withColors(
        slots: Collection<ActiveUniform>,
        level: Double,
    ): Setting = Setting(values + slots.associate { it.name to colorOf(it, level, level, level) }, texels)

    /** This with [slot] at the colour ([r], [g], [b]); a fourth component is 1. */
    fun withColor(
        slot: ActiveUniform,
        r: Double,
        g: Double,
        b: Double,
    ): Setting = Setting(values + (slot.name to colorOf(slot, r, g, b)), texels)

    /** This with the texture of each sampler a grey of the level given. */
    fun withTexels(levels: Map<String, Double>): Setting =
        Setting(values, texels + levels.mapValues { (_, level) -> FloatArray(3) { level.toFloat() } })

    private fun colorOf(
        slot: ActiveUniform,
        r: Double,
        g: Double,
        b: Double,
    ): FloatArray {
        val color = floatArrayOf(r.toFloat(), g.toFloat(), b.toFloat(), 1f)
        return FloatArray(slot.components) { color[it] }
    }
}

/**
 * The shaders of one draw as a function: surface points and settings in, colours out.
 *
 * @param values the draw's uniforms; each call may replace some.
 * @param normalLength what every normal is multiplied by.
 * @param fog that lies over what the shader lights; it is taken off before anyone looks.
 * @param exponent what the colours are raised to before anyone looks: undoes a gamma that the shader applies at its end.
 */
internal class BlackBox(
    private val rig: ProbeRig,
    val program: ProbeProgram,
    private val positionLocation: Int,
    private val normalLocation: Int?,
    private val otherLocations: List<Int>,
    val spaces: Spaces,
    val values: Map<String, FloatArray>,
    val exponent: Double = 1.0,
    private val normalLength: Double = 1.0,
    private val fog: Fog? = null,
) {
    private val toModel = spaces.modelView.invert(Matrix4d())

    /** The rotation of the model-view matrix: model normals → view normals, but for their length. */
    val rotation: Matrix3dc = Matrix3d(spaces.modelView)
    private val normalToModel = Matrix3d(spaces.modelView).transpose()

    /** Red, green, blue of each sample. */
    fun shade(
        samples: List<Sample>,
        setting: Setting,
    ): DoubleArray {
        val result = DoubleArray(3 * samples.size)
        for ((index, chunk) in samples.chunked(ProbeRig.CAPACITY).withIndex()) {
            val rgba = rig.points(program, feed(chunk), values + setting.values, setting.texels)
            for (i in chunk.indices) for (c in 0..2) result[3 * (index * ProbeRig.CAPACITY + i) + c] = decoded(rgba[4 * i + c].toDouble())
        }
        return fog?.lifted(result, samples.map { it.position }, setting) ?: result
    }

    /** The same in the middle of triangles of which [corners] gives three at a time. */
    fun shadeTriangles(
        corners: List<Sample>,
        setting: Setting,
    ): DoubleArray {
        val rgba = rig.triangles(program, feed(corners), values + setting.values, setting.texels)
        val result = DoubleArray(corners.size) { decoded(rgba[4 * (it / 3) + it % 3].toDouble()) }
        return fog?.lifted(result, corners.chunked(3) { middle(it) }, setting) ?: result
    }

    private fun middle(corners: List<Sample>): Vector3dc =
        corners.fold(Vector3d()) { sum, corner -> sum.add(corner.position) }.div(corners.size.toDouble())

    /** This box seen through another [exponent]. */
    fun decodedBy(exponent: Double): BlackBox = copy(exponent = exponent, fog = fog?.decodedBy(exponent))

    /** This box for other values of the same uniforms. */
    fun withValues(replaced: Map<String, FloatArray>): BlackBox = copy(values = values + replaced)

    /** This box for another draw with the same program. */
    fun drawn(
        spaces: Spaces,
        values: Map<String, FloatArray>,
    ): BlackBox = copy(spaces = spaces, values = values)

    /** This box with all normals [length] times as long: what a shader adds to them no longer matters. */
    fun withNormalLength(length: Double): BlackBox = copy(normalLength = length)

    /** This box without the [fog] over it. */
    fun without(fog: Fog): BlackBox = copy(fog = fog, values = values + fog.black)

    private fun copy(
        spaces: Spaces = this.spaces,
        values: Map<String, FloatArray> = this.values,
        exponent: Double = this.exponent,
        normalLength: Double = this.normalLength,
        fog: Fog? = this.fog,
    ) = BlackBox(rig, program, positionLocation, normalLocation, otherLocations, spaces, values, exponent, normalLength, fog)

    private fun decoded(value: Double) = if (exponent == 1.0) value else sign(value) * abs(value).pow(exponent)

    private fun feed(samples: List<Sample>): Feed {
        val feed = Feed(samples.size)
        val p = Vector3d()
        samples.forEachIndexed { i, sample ->
            toModel.transformPosition(sample.position, p)
            feed.set(positionLocation, i, p.x, p.y, p.z)
            if (normalLocation != null) {
                normalToModel.transform(sample.normal, p)
                p.normalize(sample.normal.length() * normalLength)
                feed.set(normalLocation, i, p.x, p.y, p.z)
            }
            for (other in otherLocations) feed.set(other, i, 0.5, 0.5, 0.5)
        }
        return feed
    }
}

/** A point of this matrix's inverse. */
internal fun Matrix4dc.back(p: Vector3dc): Vector3d = invert(Matrix4d()).transformPosition(p, Vector3d())

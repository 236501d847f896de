package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.min

/**
 * One light by itself: everything else that shines is black, and what would still shine without it is subtracted.
 *
 * @param slot its colour.
 * @param channel that is looked at: red, as a rule.
 * @param matte uniform values that leave nothing of a specular term that no texture of its own turns off; [isShine] then asks for it alone.
 */
internal class LightProbe(
    val box: BlackBox,
    val slot: ActiveUniform,
    private val colors: ColorSlots,
    private val channel: Int = 0,
    private val matte: Map<String, FloatArray> = emptyMap(),
    private val isShine: Boolean = false,
) {
    private val dark = Setting().withColors(colors.factors.filter { isBlack(box, it) }, 1.0).withColors(colors.lights + colors.flats, 0.0)
    private val lit = dark.withColors(listOf(slot), DIM)

    /** The light's specular term by itself, as its texture leaves it. */
    val shine: LightProbe get() = if (matte.isEmpty()) this else LightProbe(box, slot, colors, channel, matte, isShine = true)

    /** What the light of colour (1, 1, 1) adds to the [channel] of [samples], the textures being [texels]; [changed] replaces uniforms. */
    fun shade(
        samples: List<Sample>,
        texels: Map<String, Double>,
        changed: Map<String, FloatArray> = emptyMap(),
    ): DoubleArray {
        if (samples.isEmpty()) return DoubleArray(0)
        val with = box.shade(samples, withLight(changed).withTexels(texels))
        val without = box.shade(samples, without(changed).withTexels(texels))
        return DoubleArray(samples.size) { (with[3 * it + channel] - without[3 * it + channel]) / DIM }
    }

    /** The same in the middle of triangles. */
    fun shadeTriangles(
        corners: List<Sample>,
        texels: Map<String, Double>,
    ): DoubleArray {
        val with = box.shadeTriangles(corners, withLight(emptyMap()).withTexels(texels))
        val without = box.shadeTriangles(corners, without(emptyMap()).withTexels(texels))
        return DoubleArray(corners.size / 3) { (with[3 * it + channel] - without[3 * it + channel]) / DIM }
    }

    private fun withLight(changed: Map<String, FloatArray>) = Setting(lit.values + changed + if (isShine) emptyMap() else matte)

    private fun without(changed: Map<String, FloatArray>) = Setting((if (isShine) lit else dark).values + changed + matte)

    /** Where the light comes from at each of [points], by six normals each: brightness times direction, in terms of correct view normals. */
    fun gradients(
        points: List<Vector3dc>,
        texels: Map<String, Double>,
    ): List<Gradient> {
        val shades = shade(points.flatMap { p -> Directions.AXES.map { Sample(p, it) } }, texels)
        return points.indices.map { i ->
            val s = DoubleArray(6) { shades[6 * i + it] }
            val floor = min(min(min(s[0], s[1]), min(s[2], s[3])), min(s[4], s[5]))
            // A cone that is not clamped takes light away outside: no side is lit, and that facing the light is darkest.
            val sign = if (s.max() <= 1e-3 * -floor) -1.0 else 1.0
            Gradient(points[i], Vector3d(s[0] - s[1], s[2] - s[3], s[4] - s[5]).mul(sign), floor)
        }
    }

    private companion object {
        // So dark that a shader that clamps its result at 1 does not; a power of 2 rounds nothing.
        const val DIM = 1.0 / 64

        /** A factor that happens to be black just now (a colour that changes with time) would hide the light; one written into the shader is meant. */
        fun isBlack(
            box: BlackBox,
            factor: ActiveUniform,
        ): Boolean =
            factor.name !in box.program.constants && box.values[factor.name].let { it == null || it.take(3).any { part -> part <= 0f } }
    }
}

/**
 * How the light at a point changes with the normal.
 *
 * @param floor the least that any of the normals receives.
 */
internal class Gradient(
    val point: Vector3dc,
    val direction: Vector3dc,
    val floor: Double,
) {
    val strength: Double get() = direction.length().let { if (it.isFinite()) it else 0.0 }
}

package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4
import kotlin.math.abs

/**
 * Fog over what is lit: of a point's colour less is left the farther it is from the eye, and more of the fog's. It is seen by the emission,
 * which is the same at any distance otherwise.
 *
 * @param box the shader with its fog, for a draw in which the emission shows.
 * @param emission the sampler of the emission texture.
 */
internal class Fog private constructor(
    private val box: BlackBox,
    private val emission: String,
) {
    private val whole = glow(listOf(NEAR))[0]
    private val own by lazy { distance(Setting()) }

    /** Values that leave the fog black: what it is mixed from would only be rounded against what is lit. */
    val black: Map<String, FloatArray> by lazy {
        box.program.uniforms
            .filter { it.type == GL_FLOAT_VEC3 || it.type == GL_FLOAT_VEC4 }
            .filter { isSeen(it, 0.0) && isSeen(it, BRIGHT) }
            .associate { it.name to FloatArray(it.components) }
    }

    /** This fog seen through another gamma. */
    fun decodedBy(exponent: Double): Fog = Fog(box.decodedBy(exponent), emission)

    /**
     * What [shades], three for each of [positions] in view space, would be without fog, where the shader has [setting]; 0 where the fog leaves
     * nothing to be seen. They are of a draw with [black] values.
     */
    fun lifted(
        shades: DoubleArray,
        positions: List<Vector3dc>,
        setting: Setting,
    ): DoubleArray {
        val colors = distance(Setting(black + setting.values, setting.texels))
        val left = glow(positions).map { it / whole }
        return DoubleArray(shades.size) {
            val share = left[it / 3]
            if (share > FAINT) (shades[it] - (1 - share) * colors[it % 3]) / share else 0.0
        }
    }

    /** Whether the fog looks different with all of [slot] at [level]. */
    private fun isSeen(
        slot: ActiveUniform,
        level: Double,
    ): Boolean {
        val changed = distance(Setting().withColor(slot, level, level, level))
        return own.indices.any { abs(changed[it] - own[it]) > DIFFERENT * own.max() }
    }

    /** The fog's own colour: in the farthest distance nothing else is seen. */
    private fun distance(setting: Setting): DoubleArray = box.shade(listOf(Sample(FAR, NORMAL)), setting)

    /** How bright the emission is at [positions]. */
    private fun glow(positions: List<Vector3dc>): List<Double> = glow(box, emission, positions.map { Sample(it, NORMAL) })

    companion object {
        /** The fog over [box]; null where there is none. */
        fun over(box: BlackBox): Fog? = box.program.samplers.firstOrNull { isFaded(box, it.name) }?.let { Fog(box, it.name) }

        private fun isFaded(
            box: BlackBox,
            sampler: String,
        ): Boolean {
            val glow = glow(box, sampler, RAY.flatMap { p -> NORMALS.map { Sample(p, it) } }).chunked(NORMALS.size)
            val nearest = glow.first().first()
            if (!(nearest > 0) || glow.any { here -> here.any { abs(it - here.first()) > ALIKE * nearest } }) return false
            val isFading = glow.zipWithNext().all { (near, far) -> far.first() <= near.first() + ALIKE * nearest }
            return isFading && glow.last().first() < ALIKE * nearest
        }

        private fun glow(
            box: BlackBox,
            sampler: String,
            samples: List<Sample>,
        ): List<Double> {
            val black = Setting().withTexels(box.program.samplers.associate { it.name to 0.0 })
            val without = box.shade(samples, black)
            val with = box.shade(samples, Setting(black.values, black.texels + black.withTexels(mapOf(sampler to BRIGHT)).texels))
            return samples.indices.map { i -> (0..2).sumOf { with[3 * i + it] - without[3 * i + it] } }
        }

        private const val BRIGHT = 0.5

        private const val DIFFERENT = 1e-2
        private const val ALIKE = 1e-4

        // Of what is left, rounding takes as many times more as there is less of it.
        private const val FAINT = 1e-3
        private val NORMAL = Vector3d(0.0, 1.0, 0.0)
        private val NORMALS = listOf(NORMAL) + Directions.AXES
        private val NEAR: Vector3dc = Vector3d(0.0, 0.0, -1e-3)
        private val FAR: Vector3dc = Vector3d(0.0, 0.0, -1e6)

        /** From the eye into the distance: farther than any fog of a scene reaches. */
        private val RAY = listOf(NEAR) + List(24) { Vector3d(0.0, 0.0, -0.5 * Math.pow(2.0, 0.5 * it)) } + FAR
    }
}

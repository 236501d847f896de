package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.CapturedProgram
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.pow

/**
 * How texture coordinates are made of the attribute at [location]: factor times it plus offset, axis by axis.
 *
 * @param read what the colours of the texture that showed it are raised to, by its sampler.
 */
internal class TexCoords(
    val location: Int?,
    val read: Map<String, Double>,
    private val factor: DoubleArray,
    private val offset: DoubleArray,
) {
    /** The texture coordinate that becomes of [attribute]. */
    fun of(
        attribute: DoubleArray,
        axis: Int,
    ): Double = factor[axis] * attribute[axis] + offset[axis]

    companion object {
        /**
         * Finds out by having the textures of [samplers], which are multiplied, show where they are read, their colours raised to [power],
         * which is tried out where it is null. Null where that cannot be compiled or gives no straight line.
         */
        fun of(
            reading: Reading,
            pairs: List<Int>,
            samplers: Set<String>,
            power: Double?,
        ): TexCoords? =
            try {
                ProbeProgram(reading.shown()).use { where ->
                    ProbeProgram(reading.captured).use { usual ->
                        val powers = listOfNotNull(power).ifEmpty { POWERS }
                        powers.firstNotNullOfOrNull { measure(Shown(reading, where, usual, samplers, it), pairs) }
                    }
                }
            } catch (_: InputError) {
                null
            }

        private fun measure(
            shown: Shown,
            pairs: List<Int>,
        ): TexCoords? {
            val at = pairs.firstOrNull { location -> shown.at(location, 0.0, 0.0) != shown.at(location, STEP, STEP) }
            // Where nothing moves them, all of the surface shows the same texel.
            if (at == null) return shown.at(NOWHERE, 0.0, 0.0)?.let { TexCoords(null, shown.read, DoubleArray(2), it.toDoubleArray()) }
            val zero = shown.at(at, 0.0, 0.0) ?: return null
            val one = shown.at(at, STEP, STEP) ?: return null
            val two = shown.at(at, 2 * STEP, 2 * STEP) ?: return null
            val isStraight = (0..1).all { abs(two[it] - 2 * one[it] + zero[it]) <= STRAIGHT * (abs(two[it] - zero[it]) + TINY) }
            if (!isStraight) return null
            return TexCoords(at, shown.read, DoubleArray(2) { (one[it] - zero[it]) / STEP }, zero.toDoubleArray())
        }

        /** Small enough that a shader that clamps its colour at 1 does not clamp what is shown. */
        private const val STEP = 1.0 / 512
        private const val STRAIGHT = 1e-3
        private const val TINY = 1e-5
        private const val NOWHERE = -1
        private val POWERS = listOf(1.0, 2.2, 2.0)
    }
}

/**
 * A program of a submission and how it is drawn with.
 *
 * @param gamma what its picture has to be raised to for light to add up.
 */
internal class Reading(
    val rig: ProbeRig,
    val captured: CapturedProgram,
    val locations: List<Int>,
    val values: Map<String, FloatArray>,
    val gamma: Double,
) {
    /** The program with texture coordinates in the place of texels, times the texel; a macro does not call itself. */
    fun shown() =
        CapturedProgram(
            captured.vertexSource,
            LiftedConstants.afterVersion(
                LiftedConstants.withoutComments(captured.fragmentSource),
                "#define texture(s, uv) (texture(s, vec2(0.5)) * vec4((uv), 0.0, 1.0))",
            ),
            captured.attributes,
            captured.outputs,
            captured.substituted,
        )
}

/** A program that shows where it reads the textures of [samplers], beside the same that reads grey ones; all others are black. */
private class Shown(
    private val reading: Reading,
    private val where: ProbeProgram,
    private val usual: ProbeProgram,
    private val samplers: Set<String>,
    private val power: Double,
) {
    val read = samplers.associateWith { power }

    /** Red and green for the attribute [location] at ([u], [v]) as texture coordinates; null where nothing shows. */
    fun at(
        location: Int,
        u: Double,
        v: Double,
    ): List<Double>? {
        val feed = Feed(1)
        for (each in reading.locations) feed.set(each, 0, SOME[0], SOME[1], SOME[2])
        if (location >= 0) feed.set(location, 0, u, v)
        val dark = light(usual, feed, 0.0)
        val full = light(usual, feed, ColorSlots.DARK)
        val read = light(where, feed, 1.0)
        val shares = (0..1).map {
            ColorSlots.DARK * max(
                (read[it] - dark[it]) / (full[it] - dark[it]),
                0.0,
            ).pow(1 / (power * samplers.size))
        }
        return shares.takeIf { all -> all.all { it.isFinite() } }
    }

    private fun light(
        program: ProbeProgram,
        feed: Feed,
        texel: Double,
    ): List<Double> {
        val texels = usual.samplers.associate { it.name to FloatArray(3) { _ -> if (it.name in samplers) texel.toFloat() else 0f } }
        val colors = reading.rig.points(program, feed, program.constants + reading.values, texels)
        return (0..1).map { max(colors[it].toDouble(), 0.0).pow(reading.gamma) }
    }

    private companion object {
        val SOME = doubleArrayOf(0.3, 0.4, 0.5)
    }
}

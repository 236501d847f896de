package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.max
import kotlin.math.pow
import kotlin.random.Random

/** The cosines that a specular term may be a power of. */
internal enum class Lobe {
    BLINN,
    PHONG,

    /** The half vector as the sum or the mean of unit vectors. */
    BLINN_LONG,

    /** The half vector from vectors that were never normalised. */
    BLINN_RAW,
}

/** The vector that a shader takes for the one to the eye. */
internal enum class EyeVector { RIGHT, REVERSED, FROM_WORLD_ORIGIN, TO_WORLD_ORIGIN, WORLD_AXES, VIEW_AXES }

/**
 * The specular term fitted by a power of one of the cosines.
 *
 * @param error what the fit leaves, relative to what is there.
 * @param unclamped whether there is light where the cosine is negative.
 */
internal class HighlightFit(
    val lobe: Lobe,
    val eye: EyeVector,
    val lightReversed: Boolean,
    val exponent: Double,
    val error: Double,
    val unclamped: Boolean,
) {
    /** cos β, possibly beyond 1 for half vectors that are not normalised; [toLight] and [toEye] have their lengths, n is a unit vector. */
    fun cosine(
        n: Vector3dc,
        toLight: Vector3dc,
        toEye: Vector3dc,
    ): Double = cosine(lobe, n, if (lightReversed) Vector3d(toLight).negate() else toLight, toEye)

    /** What is left of [cosine], clamped where the shader clamps, to the power of the exponent. */
    fun value(cosine: Double): Double = if (cosine > 0) {
        cosine.pow(exponent)
    } else if (unclamped) {
        abs(cosine).pow(exponent)
    } else {
        0.0
    }

    companion object {
        fun cosine(
            lobe: Lobe,
            n: Vector3dc,
            toLight: Vector3dc,
            toEye: Vector3dc,
        ): Double {
            val l = Vector3d(toLight).normalize()
            val v = Vector3d(toEye).normalize()
            return when (lobe) {
                Lobe.PHONG -> 2 * n.dot(l) * n.dot(v) - l.dot(v)
                Lobe.BLINN -> n.dot(l.add(v).normalize())
                Lobe.BLINN_LONG -> n.dot(l.add(v)) / 2
                Lobe.BLINN_RAW -> n.dot(Vector3d(toLight).add(toEye).normalize())
            }
        }

        /** The vector to the eye of kind [eye] in the space of [placement]; null where the world is not known. */
        fun toEye(
            eye: EyeVector,
            spaces: Spaces,
            placement: Placement,
            p: Vector3dc,
        ): Vector3d? {
            val right = placement.toCamera(p)
            val world = spaces.to(Space.WORLD)
            return when (eye) {
                EyeVector.RIGHT -> right
                EyeVector.REVERSED -> right.negate()
                EyeVector.TO_WORLD_ORIGIN -> world?.transformPosition(p, Vector3d())?.negate()
                EyeVector.FROM_WORLD_ORIGIN -> world?.transformPosition(p, Vector3d())
                EyeVector.VIEW_AXES -> Vector3d(p).negate()
                EyeVector.WORLD_AXES -> world?.transformDirection(Vector3d(p).negate())
            }
        }

        /** Fits the light of [probe] as [texels] leave it, at [points] that it shines on; null where there is nothing. */
        fun of(
            probe: LightProbe,
            placement: Placement,
            points: List<Vector3dc>,
            texels: Map<String, Double>,
        ): HighlightFit? {
            val spaces = probe.box.spaces
            val samples = samples(placement, points)
            val values = probe.shade(samples, texels)
            if (!(values.largest() > 0)) return null
            val fits =
                EyeVector.entries.flatMap { eye ->
                    Lobe.entries.flatMap { lobe ->
                        listOf(false, true).mapNotNull { reversed ->
                            HighlightRegression(spaces, placement, lobe, eye, reversed).fit(samples, values)
                        }
                    }
                }
            val best = fits.minByOrNull { it.error } ?: return null
            // Where two fit alike the first is the simpler one: right vectors come first.
            return fits.first { it.error <= best.error * 1.5 + 1e-5 }
        }

        private fun samples(
            placement: Placement,
            points: List<Vector3dc>,
        ): List<Sample> {
            val random = Random(6)
            return points.flatMap { p ->
                val l = placement.toLight(p).normalize()
                val v = placement.toCamera(p).normalize()
                val centres = listOf(Vector3d(l).add(v), Vector3d(l).sub(v), Vector3d(v).sub(l)).map { it.normalize() }
                val near =
                    centres.flatMap { c ->
                        List(TILTS) { Directions.around(c, 0.01 * TILT_GROWTH.pow(it), random.nextDouble(2 * Math.PI)) }
                    }
                (near + List(TILTS) { Directions.random(random) }).map { Sample(p, placement.normalFor(it)) }
            }
        }

        const val TILTS: Int = 14
        private const val TILT_GROWTH = 1.36

        /** Samples of one point, by which [HighlightRegression] groups them. */
        const val PER_POINT: Int = 4 * TILTS
    }
}

/** One hypothesis about the specular term, fitted in logarithms: the exponent is common, every point has a strength of its own. */
internal class HighlightRegression(
    private val spaces: Spaces,
    private val placement: Placement,
    private val lobe: Lobe,
    private val eye: EyeVector,
    private val reversed: Boolean,
) {
    fun fit(
        samples: List<Sample>,
        values: DoubleArray,
    ): HighlightFit? {
        samplesSeen = samples
        val cosines = DoubleArray(samples.size) { cosine(samples[it]) ?: return null }
        val brightest = values.largest()
        var xx = 0.0
        var xy = 0.0
        val groups = samples.indices.chunked(HighlightFit.PER_POINT)
        val used = groups.map { group -> group.filter { values[it] > VISIBLE * brightest && cosines[it] > 1e-3 } }
        for (group in used) {
            if (group.size < 3) continue
            val meanX = group.sumOf { ln(cosines[it]) } / group.size
            val meanY = group.sumOf { ln(values[it]) } / group.size
            for (i in group) {
                xx += (ln(cosines[i]) - meanX) * (ln(cosines[i]) - meanX)
                xy += (ln(cosines[i]) - meanX) * (ln(values[i]) - meanY)
            }
        }
        if (!(xx > 0)) return null
        val exponent = xy / xx
        return judge(groups, used, cosines, values, exponent)
    }

    private fun judge(
        groups: List<List<Int>>,
        used: List<List<Int>>,
        cosines: DoubleArray,
        values: DoubleArray,
        exponent: Double,
    ): HighlightFit {
        var difference = 0.0
        var sum = 0.0
        var negative = 0.0
        var positive = 0.0
        for ((group, bright) in groups.zip(used)) {
            val strength = if (bright.isEmpty()) {
                0.0
            } else {
                Math.exp(bright.sumOf { ln(values[it]) - exponent * ln(cosines[it]) } / bright.size)
            }
            for (i in group) {
                if (!values[i].isFinite()) continue
                val power = strength * abs(cosines[i]).pow(exponent)
                sum += abs(values[i])
                if (cosines[i] > 0) {
                    // A highlight may be gated by n·l: nothing where the light is behind the surface is no difference.
                    if (values[i] != 0.0 || !isBehind(i)) difference += abs(values[i] - power)
                    positive += power
                } else {
                    negative += abs(values[i])
                    if (values[i] != 0.0) difference += abs(abs(values[i]) - power)
                }
            }
        }
        return HighlightFit(lobe, eye, reversed, exponent, difference / max(sum, 1e-300), negative > 1e-3 * max(positive, 1e-300))
    }

    private var samplesSeen: List<Sample> = emptyList()

    private fun isBehind(i: Int): Boolean {
        val sample = samplesSeen[i]
        return placement.normalOf(sample.normal).dot(placement.toLight(sample.position)) <= 0
    }

    private fun cosine(sample: Sample): Double? {
        val v = HighlightFit.toEye(eye, spaces, placement, sample.position) ?: return null
        val l = placement.toLight(sample.position)
        return HighlightFit.cosine(lobe, placement.normalOf(sample.normal).normalize(), if (reversed) l.negate() else l, v)
    }

    private companion object {
        const val VISIBLE = 1e-5
    }
}

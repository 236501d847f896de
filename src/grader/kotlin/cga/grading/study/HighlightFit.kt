package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
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

package cga.reference

import org.joml.Vector3dc
import kotlin.math.atan2
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * How much of a spotlight shines at the angle θ from its axis (sheet 4, task 4.3, with the angles as its prose names them):
 *
 *     I = clamp((cos θ − cos outer) / (cos inner − cos outer), 0, 1)
 *
 * Differences of cosines of small angles cancel: both are almost 1. So the angles themselves are kept, θ comes from an arc tangent,
 * which is accurate at every angle where an arc cosine is not, and each difference is written as a product,
 *
 *     cos a − cos b = 2·sin((b + a)/2)·sin((b − a)/2).
 *
 * The rounding of two vectors, 1e-16, is then all that is left: relative to the cone it grows as 1/outer (1e-11 at 0.001°), with
 * cosines as 1/outer² (1e-6).
 *
 * @param axis s, a vector in view space, away from the light.
 * @param inner γ of the prose, up to where I = 1; [outer], its φ, from where I = 0. Radians.
 */
internal class Cone(
    private val axis: Vector3dc,
    private val inner: Double,
    private val outer: Double,
) {
    /** θ, between the axis and the ray from the light to the surface; [toLight] points the other way and has any length but 0. */
    fun angle(toLight: Vector3dc): Double {
        val x = axis.y() * toLight.z() - axis.z() * toLight.y()
        val y = axis.z() * toLight.x() - axis.x() * toLight.z()
        val z = axis.x() * toLight.y() - axis.y() * toLight.x()
        return atan2(sqrt(x * x + y * y + z * z), -axis.dot(toLight))
    }

    /** I at the angle [theta]; a step where the two angles of the cone are the same. */
    fun intensity(theta: Double): Double =
        when {
            theta <= inner -> 1.0
            theta >= outer -> 0.0
            else -> differenceOfCosines(theta, outer) / differenceOfCosines(inner, outer)
        }

    /** Half of cos [a] − cos [b]. */
    private fun differenceOfCosines(
        a: Double,
        b: Double,
    ) = sin((b + a) / 2) * sin((b - a) / 2)
}

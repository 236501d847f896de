package cga.reference

import org.joml.Vector3fc
import kotlin.math.max

/**
 * How much of a light arrives from the distance d (sheet 4, task 4.3.4):
 *
 *     F = 1 / (K_c + K_l·d + K_q·d²)
 *
 * but no more than 1e18 (a light with K_c = 0, all but touching the surface): that times the light's colour is still a float.
 */
internal class Attenuation(k: Vector3fc) {
    private val kConstant = k.x().toDouble()
    private val kLinear = k.y().toDouble()
    private val kQuadratic = k.z().toDouble()

    /** F; 0 for a light at the surface itself, which has no direction, and for one so far away that d² is beyond all floats. */
    fun factor(d: Double): Double {
        if (d == 0.0 || d * d > LARGEST_FLOAT) return 0.0
        return 1 / max(kConstant + kLinear * d + kQuadratic * d * d, 1 / LARGEST)
    }

    private companion object {
        const val LARGEST_FLOAT = Float.MAX_VALUE.toDouble()
        const val LARGEST = 1e18
    }
}

package cga.reference

import cga.framework.SpecularModel
import org.joml.Vector3dc
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * cos β, whose power is the highlight; n, l and v are unit vectors: normal, to the light, to the eye.
 *
 * Phong (1975; sheet 4, task 4.1): β lies between v and the light's reflection r = 2·(n·l)·n − l.
 * Blinn (1977; task 4.7): β lies between n and the half vector h = (l + v) / |l + v|.
 */
internal fun cosBeta(
    model: SpecularModel,
    n: Vector3dc,
    l: Vector3dc,
    v: Vector3dc,
): Double =
    when (model) {
        SpecularModel.PHONG -> 2 * n.dot(l) * n.dot(v) - l.dot(v)
        SpecularModel.BLINN_PHONG -> cosToHalfVector(n, l, v)
    }

/** max(cos β, 0)^k; 0 where the cosine is 0, also for k = 0: 0⁰ is not asked for. */
internal fun highlight(
    cosBeta: Double,
    k: Double,
): Double = if (cosBeta > 0) cosBeta.pow(k) else 0.0

/** n·h; 0 where light and eye are opposite each other and there is no half vector. */
private fun cosToHalfVector(
    n: Vector3dc,
    l: Vector3dc,
    v: Vector3dc,
): Double {
    val x = l.x() + v.x()
    val y = l.y() + v.y()
    val z = l.z() + v.z()
    val length = sqrt(x * x + y * y + z * z)
    return if (length > NO_HALF_VECTOR) (n.x() * x + n.y() * y + n.z() * z) / length else 0.0
}

/** What the sum of two opposite unit vectors can be by rounding alone: four units in the last place of 1. */
private const val NO_HALF_VECTOR = 4 * 2.220446049250313e-16

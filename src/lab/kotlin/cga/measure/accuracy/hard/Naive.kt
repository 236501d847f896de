package cga.measure.accuracy.hard

import cga.framework.SpecularModel
import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.pow
import kotlin.math.sqrt

/** The lighting model as one writes it down at first, in floats, which GLSL computes alike. */
internal object Naive {
    /** v / |v|; NaN for 0. */
    fun normalize(v: Vector3fc): Vector3f = length(v).let { Vector3f(v.x() / it, v.y() / it, v.z() / it) }

    /** (cos θ − cos outer) / (cos inner − cos outer), clamped; [fromLight] and [axis] are normalised here. */
    fun cone(
        fromLight: Vector3fc,
        axis: Vector3fc,
        inner: Float,
        outer: Float,
    ): Float {
        val cosOuter = cos(outer)
        val ratio = (dot(normalize(fromLight), normalize(axis)) - cosOuter) / (cos(inner) - cosOuter)
        return if (ratio.isNaN()) ratio else ratio.coerceIn(0f, 1f)
    }

    /** 1 / (K_c + K_l·d + K_q·d²). */
    fun attenuation(
        toLight: Vector3fc,
        k: Vector3fc,
    ): Float = length(toLight).let { d -> 1f / (k.x() + k.y() * d + k.z() * d * d) }

    /** max(n·l, 0). */
    fun diffuse(
        normal: Vector3fc,
        toLight: Vector3fc,
    ): Float = max(dot(normalize(normal), normalize(toLight)), 0f)

    /** max(cos β, 0)^k. */
    fun specular(
        model: SpecularModel,
        normal: Vector3fc,
        toLight: Vector3fc,
        toCamera: Vector3fc,
        k: Float,
    ): Float = max(cosBeta(model, normalize(normal), normalize(toLight), normalize(toCamera)), 0f).pow(k)

    /** cos β of unit vectors. */
    fun cosBeta(
        model: SpecularModel,
        n: Vector3fc,
        l: Vector3fc,
        v: Vector3fc,
    ): Float =
        when (model) {
            SpecularModel.PHONG -> 2f * dot(n, l) * dot(n, v) - dot(l, v)
            SpecularModel.BLINN_PHONG -> dot(n, normalize(Vector3f(l.x() + v.x(), l.y() + v.y(), l.z() + v.z())))
        }

    /** Not JOML's, which may fuse. */
    fun dot(
        a: Vector3fc,
        b: Vector3fc,
    ): Float = a.x() * b.x() + a.y() * b.y() + a.z() * b.z()

    private fun length(v: Vector3fc) = sqrt(dot(v, v))
}

package cga.inspect.probe

import cga.framework.Frame
import cga.inspect.view.Look
import cga.inspect.view.View
import cga.reference.LightContribution
import cga.reference.ShadedPoint
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.max
import kotlin.math.pow

/** What a view shows of a shaded point, from the reference's numbers: the truth beside the value of the GPU. */
internal object Expected {
    /** The colour that [look] makes of [point], which the reference found in [frame]; unclamped. */
    fun color(
        point: ShadedPoint,
        frame: Frame,
        look: Look,
    ): Vector3d {
        val light = point.lights.getOrNull(look.light)
        return when (look.view) {
            View.NORMAL -> direction(point.normal)
            View.TO_CAMERA -> direction(point.toCamera)
            View.TO_LIGHT -> direction(light?.toLight ?: Vector3d())
            View.HALF_VECTOR -> direction(halfVector(point, light))
            View.REFLECTED -> direction(reflected(point, light))
            View.COS_ALPHA -> number(light?.cosAlpha ?: 0.0)
            View.COS_BETA -> number(light?.cosBeta ?: 0.0)
            View.HIGHLIGHT -> number(highlight(light, frame.draws[point.draw].material.shininess.toDouble()))
            View.ATTENUATION -> number(light?.attenuation ?: 0.0)
            View.CONE -> number(light?.cone ?: 1.0)
            else -> encode(radiance(point, look), frame.gamma.toDouble())
        }
    }

    /** The sum of the terms that [look] shows, of the lights that are on. */
    fun radiance(
        point: ShadedPoint,
        look: Look,
    ): Vector3d {
        val sum = Vector3d()
        val view = look.view
        if (view == View.FULL || view == View.EMISSION) sum.add(point.emission)
        if (view == View.FULL || view == View.AMBIENT) sum.add(point.ambient)
        for ((i, share) in point.lights.withIndex()) {
            if (!look.isOn(i)) continue
            if (view == View.FULL || view == View.DIFFUSE) sum.add(share.diffuse)
            if (view == View.FULL || view == View.SPECULAR) sum.add(share.specular)
        }
        return sum
    }

    /** h, unit length; 0 where light and eye are opposite each other. */
    fun halfVector(
        point: ShadedPoint,
        light: LightContribution?,
    ): Vector3d = unit(Vector3d(light?.toLight ?: Vector3d()).add(point.toCamera))

    private fun reflected(
        point: ShadedPoint,
        light: LightContribution?,
    ): Vector3d {
        val l = light?.toLight ?: return Vector3d()
        return if (point.normal.lengthSquared() == 0.0) Vector3d() else Vector3d(point.normal).mul(2 * point.normal.dot(l)).sub(l)
    }

    private fun highlight(
        light: LightContribution?,
        k: Double,
    ): Double = light?.cosBeta?.takeIf { it > 0 }?.pow(k) ?: 0.0

    private fun direction(v: Vector3dc): Vector3d = if (v.lengthSquared() == 0.0) Vector3d() else Vector3d(v).add(1.0, 1.0, 1.0).div(2.0)

    private fun number(x: Double): Vector3d {
        if (x < 0) return Vector3d(0.0, 0.0, -x).min(Vector3d(1.0))
        val above = (x - 1).coerceIn(0.0, 1.0)
        return Vector3d(1.0, 1 - above / 2, 1 - above).mul(minOf(x, 1.0))
    }

    private fun encode(
        color: Vector3d,
        gamma: Double,
    ): Vector3d {
        if (gamma == 1.0) return color
        for (i in 0..2) color.setComponent(i, max(color[i], 0.0).pow(1 / gamma))
        return color
    }

    private fun unit(v: Vector3d): Vector3d = if (v.length() > 0) v.normalize() else v
}

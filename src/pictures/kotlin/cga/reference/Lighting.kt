package cga.reference

import cga.framework.Frame
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.max
import kotlin.math.pow

/**
 * The lighting model of sheet 4, everything in view space, where the eye is at the origin:
 *
 *     L_O = M_e·tint + M_d·L_a + Σ I·F·(M_d·max(cos α, 0) + M_s·max(cos β, 0)^k)·L
 *
 * α lies between the normal n and the vector l to the light; for β see [cosBeta], for F [Attenuation], for I [Cone].
 * As on the sheet the specular term is not cut off where the light is behind the surface.
 */
public class Lighting(frame: Frame) {
    private val lights = ViewLight.of(frame)
    private val ambientLight = Vector3d(frame.ambient)
    private val specularModel = frame.specularModel
    private val gamma = frame.gamma.toDouble()

    /** A point for [shade], with room for this frame's lights. */
    public fun newPoint(): ShadedPoint = ShadedPoint(lights.size)

    /**
     * Fills in the terms and the colours of [point], whose position, normal and material are set.
     *
     * @param tint factor of the emissive colour.
     * @param k the specular exponent.
     */
    public fun shade(
        point: ShadedPoint,
        tint: Vector3dc,
        k: Double,
    ) {
        point.normal.normalizeOrZero()
        point.position.negate(point.toCamera).normalizeOrZero()

        point.emissive.mul(tint, point.emission)
        point.diffuse.mul(ambientLight, point.ambient)
        point.radiance.set(point.emission).add(point.ambient)
        for (i in lights.indices) {
            val share = point.lights[i]
            illuminate(point, lights[i], k, share)
            point.radiance.add(share.diffuse).add(share.specular)
        }
        encode(point.radiance, point.color)
    }

    private fun illuminate(
        point: ShadedPoint,
        light: ViewLight,
        k: Double,
        share: LightContribution,
    ) {
        val n = point.normal
        val l = light.position.sub(point.position, share.toLight)
        share.distance = l.length()
        share.attenuation = light.attenuation.factor(share.distance)
        share.theta = light.cone?.angle(l) ?: 0.0
        share.cone = light.cone?.intensity(share.theta) ?: 1.0
        l.normalizeOrZero()

        share.cosAlpha = n.dot(l)
        share.cosBeta = cosBeta(specularModel, n, l, point.toCamera)
        // Without a normal, or at the light itself, there are no angles: reflecting at n = 0 would even give the light's own direction.
        val hasAngles = n.lengthSquared() > 0 && share.distance > 0
        val strength = if (hasAngles) share.cone * share.attenuation else 0.0
        val lambert = strength * max(share.cosAlpha, 0.0)
        val gloss = if (strength > 0) strength * highlight(share.cosBeta, k) else 0.0
        point.diffuse.mul(light.color, share.diffuse).mul(lambert)
        point.specular.mul(light.color, share.specular).mul(gloss)
    }

    /** Colours for a screen of the given gamma; 1 leaves them as they are (the sheet's footnote 2). */
    private fun encode(
        radiance: Vector3dc,
        color: Vector3d,
    ) {
        color.set(radiance)
        if (gamma == 1.0) return
        color.set(encode(color.x), encode(color.y), encode(color.z))
    }

    private fun encode(value: Double): Double = max(value, 0.0).pow(1 / gamma)
}

/** Where the vector is 0, so is every cosine with it. */
private fun Vector3d.normalizeOrZero(): Vector3d {
    val length = length()
    return if (length > 0) div(length) else zero()
}

package cga.reference

import org.joml.Vector2d
import org.joml.Vector3d

/**
 * One point of a surface and every number that made its colour, under the names of the sheet; all vectors in view space, all colours
 * linear RGB.
 *
 * The renderer keeps one for each of its threads and fills it again and again; one that [ReferenceRenderer.probe] returns is the
 * caller's own.
 */
public class ShadedPoint internal constructor(lights: Int) {
    /** Number of the draw in the frame. */
    public var draw: Int = 0
        internal set

    /** Number of the triangle in the draw. */
    public var triangle: Int = 0
        internal set

    /** Window depth, 0 at the near plane and 1 at the far plane. */
    public var depth: Double = 0.0
        internal set

    /** Texture coordinates (s, t), multiplied. */
    public val texCoord: Vector2d = Vector2d()

    /** How they change from one pixel to the next on the right, and to the next above. */
    public val texCoordDx: Vector2d = Vector2d()
    public val texCoordDy: Vector2d = Vector2d()

    /** Where the point is. The eye is at the origin. */
    public val position: Vector3d = Vector3d()

    /** n, unit length; 0 where the interpolated normal is. */
    public val normal: Vector3d = Vector3d()

    /** v, from the point to the eye, unit length. */
    public val toCamera: Vector3d = Vector3d()

    /** M_e, M_d, M_s: what the textures say here. */
    public val emissive: Vector3d = Vector3d()
    public val diffuse: Vector3d = Vector3d()
    public val specular: Vector3d = Vector3d()

    /** M_e·tint. */
    public val emission: Vector3d = Vector3d()

    /** M_d·L_a. */
    public val ambient: Vector3d = Vector3d()

    /** What each of the frame's lights adds. */
    public val lights: List<LightContribution> = List(lights) { LightContribution() }

    /** L_O, the sum of it all. */
    public val radiance: Vector3d = Vector3d()

    /** What is written to the picture: [radiance] to the power of 1/gamma. */
    public val color: Vector3d = Vector3d()
}

/**
 * The share of one light: I·F·(M_d·max(cos α, 0) + M_s·max(cos β, 0)^k)·L. The shares of a light that has no effect at all (d = 0, no
 * normal) are 0.
 */
public class LightContribution internal constructor() {
    /** d, from the point to the light. */
    public var distance: Double = 0.0
        internal set

    /** F. */
    public var attenuation: Double = 0.0
        internal set

    /** θ, from the axis of a spotlight; 0 for a point light. Radians. */
    public var theta: Double = 0.0
        internal set

    /** I, 1 for a point light. */
    public var cone: Double = 0.0
        internal set

    /** l, from the point to the light, unit length; 0 for d = 0. */
    public val toLight: Vector3d = Vector3d()

    /** n·l, not clamped. */
    public var cosAlpha: Double = 0.0
        internal set

    /** r·v (Phong) or n·h (Blinn-Phong), not clamped. */
    public var cosBeta: Double = 0.0
        internal set

    /** I·F·M_d·max(cos α, 0)·L. */
    public val diffuse: Vector3d = Vector3d()

    /** I·F·M_s·max(cos β, 0)^k·L. */
    public val specular: Vector3d = Vector3d()
}

package cga.framework

import org.joml.Vector3dc
import org.joml.Vector3fc

/**
 * A light of a [Frame].
 *
 * @param position in world space.
 * @param color linear RGB, may exceed 1.
 * @param attenuation (K_c, K_l, K_q) of F = 1 / (K_c + K_l·d + K_q·d²).
 * @param cone null for a point light, which shines evenly in every direction.
 */
public class FrameLight(
    public val position: Vector3dc,
    public val color: Vector3fc,
    public val attenuation: Vector3fc,
    public val cone: FrameCone? = null,
)

/**
 * Where a spotlight shines.
 *
 * @param direction unit vector in world space, away from the light.
 * @param innerAngle between the axis and the edge of full light, radians in [0, π/2].
 * @param outerAngle between the axis and the edge of darkness, radians in [innerAngle, π/2].
 */
public class FrameCone(
    public val direction: Vector3dc,
    public val innerAngle: Float,
    public val outerAngle: Float,
)

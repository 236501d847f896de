package cga.reference

import cga.framework.Frame
import cga.framework.FramePointLight
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A light of the frame, in view space.
 *
 * @param color L.
 * @param cone null for a point light.
 */
internal class ViewLight(
    val position: Vector3dc,
    val color: Vector3dc,
    val attenuation: Attenuation,
    val cone: Cone?,
) {
    companion object {
        /** The point lights, then the spotlights. */
        fun of(frame: Frame): List<ViewLight> =
            frame.pointLights.map { of(frame, it, null) } +
                frame.spotLights.map {
                    val axis = frame.view.transformDirection(it.direction, Vector3d())
                    of(frame, it.light, Cone(axis, it.innerAngle.toDouble(), it.outerAngle.toDouble()))
                }

        private fun of(
            frame: Frame,
            light: FramePointLight,
            cone: Cone?,
        ) = ViewLight(
            position = frame.view.transformPosition(light.position, Vector3d()),
            color = Vector3d(light.color),
            attenuation = Attenuation(light.attenuation),
            cone = cone,
        )
    }
}

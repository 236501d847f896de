package cga.reference

import cga.framework.Frame
import cga.framework.FrameCone
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
        /** The lights of [frame], in its order. */
        fun of(frame: Frame): List<ViewLight> =
            frame.lights.map { light ->
                ViewLight(
                    position = frame.view.transformPosition(light.position, Vector3d()),
                    color = Vector3d(light.color),
                    attenuation = Attenuation(light.attenuation),
                    cone = light.cone?.let { cone(it, frame) },
                )
            }

        private fun cone(
            cone: FrameCone,
            frame: Frame,
        ) = Cone(frame.view.transformDirection(cone.direction, Vector3d()), cone.innerAngle.toDouble(), cone.outerAngle.toDouble())
    }
}

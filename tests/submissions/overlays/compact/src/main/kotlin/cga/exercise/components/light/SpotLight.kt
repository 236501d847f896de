package cga.exercise.components.light

import org.joml.Vector3f

/** Shines along its negative z axis. */
class SpotLight(position: Vector3f, color: Hsv, cone: Cone) : PointLight(position, color, FALLOFF, cone), ISpotLight {
    companion object {
        val FALLOFF = Vector3f(0.5f, 0.05f, 0.01f)
    }
}

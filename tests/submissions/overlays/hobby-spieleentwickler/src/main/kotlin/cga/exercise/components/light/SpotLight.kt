package cga.exercise.components.light

import org.joml.Vector3f
import kotlin.math.cos

/** Just a point light with a real cone; angles in radians, measured from the axis. */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, color, Falloff.SPOT, Cone(cos(innerAngle), cos(outerAngle))), ISpotLight

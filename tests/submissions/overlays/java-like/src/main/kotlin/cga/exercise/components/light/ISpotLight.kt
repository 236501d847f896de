package cga.exercise.components.light

import org.joml.Vector3f

interface ISpotLight {
    fun getWorldDirection(): Vector3f
    fun getInnerAngle(): Float
    fun getOuterAngle(): Float
}

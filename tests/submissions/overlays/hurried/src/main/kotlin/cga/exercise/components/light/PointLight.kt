package cga.exercise.components.light

import org.joml.Vector3f

data class PointLight(
    val pos: Vector3f,
    val col: Vector3f,
    val k: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
)

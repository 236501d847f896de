package cga.exercise.components.light

import org.joml.Vector3f

data class SpotLight(
    val pos: Vector3f,
    val dir: Vector3f,
    val col: Vector3f,
    val inner: Float,
    val outer: Float,
    val k: Vector3f = Vector3f(0.5f, 0.05f, 0.01f)
)

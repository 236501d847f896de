package cga.exercise.components.light

import org.joml.Vector3f

/** Table 1 of the sheet. */
enum class Attenuation(constant: Float, linear: Float, quadratic: Float) {
    POINT(1.0f, 0.5f, 0.1f),
    SPOT(0.5f, 0.05f, 0.01f);

    val factors = Vector3f(constant, linear, quadratic)
}

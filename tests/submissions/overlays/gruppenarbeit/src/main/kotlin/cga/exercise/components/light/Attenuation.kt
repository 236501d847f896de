package cga.exercise.components.light

import org.joml.Vector3f

/** 1 / (constant + linear * d + quadratic * d^2) */
data class Attenuation(val constant: Float, val linear: Float, val quadratic: Float) {
    fun toVector() = Vector3f(constant, linear, quadratic)

    companion object {
        // table 1 of the sheet
        val POINT = Attenuation(1.0f, 0.5f, 0.1f)
        val SPOT = Attenuation(0.5f, 0.05f, 0.01f)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.math.*
import org.joml.Vector3f

open class PointLight(x: Float, y: Float, z: Float, var rgb: FloatArray) : Transformable() {
    open val k = floatArrayOf(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(Vector3f(x, y, z))
    }

    /** position in view space, colour, attenuation: 9 floats */
    fun pack(view: FloatArray): FloatArray = apply(view, floats(getWorldPosition()), 1f) + rgb + k
}

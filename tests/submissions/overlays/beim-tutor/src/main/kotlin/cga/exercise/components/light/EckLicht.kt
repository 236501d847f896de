package cga.exercise.components.light

import org.joml.Vector3f

/** Punktlicht in einer Ecke der Ground Plane (4.6), steht fest */
class EckLicht(x: Float, z: Float, farbton: Vector3f) :
    PointLight(Vector3f(x, HOEHE, z), Vector3f(farbton).mul(STAERKE)) {

    companion object {
        const val HOEHE = 1.4f
        const val STAERKE = 7.0f
    }
}

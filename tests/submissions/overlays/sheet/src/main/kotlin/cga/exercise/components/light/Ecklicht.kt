package cga.exercise.components.light

import org.joml.Vector3f

/** Ein Punktlicht in einer Ecke der Ground Plane. */
class Ecklicht(richtungX: Int, richtungZ: Int, lichtfarbe: Vector3f) :
    PointLight(Vector3f(richtungX * ABSTAND, HOEHE, richtungZ * ABSTAND), lichtfarbe) {

    companion object {
        private const val ABSTAND = 16.0f
        private const val HOEHE = 1.8f
    }
}

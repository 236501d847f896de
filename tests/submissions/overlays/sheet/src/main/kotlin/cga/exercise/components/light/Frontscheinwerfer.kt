package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import org.joml.Math
import org.joml.Vector3f

/** Das Spotlight vorne am Motorrad. */
class Frontscheinwerfer(motorrad: Transformable) : SpotLight(
    Vector3f(0.0f, 0.85f, -1.8f),
    Vector3f(3.0f, 2.9f, 2.4f),
    Math.toRadians(13.0f),
    Math.toRadians(28.0f)
) {
    init {
        // leicht nach unten neigen
        rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
        parent = motorrad
    }
}

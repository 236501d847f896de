package cga.exercise.game

import cga.exercise.components.geometry.Transformable
import org.joml.Vector3f

/** Steering node. The bike mesh is one piece, so only the headlight hangs on it. */
class Handlebar(private val fork: Vector3f) : Transformable() {

    init {
        steer(0.0f)
    }

    fun steer(angle: Float) {
        local.translation(fork).rotateY(angle)
    }
}

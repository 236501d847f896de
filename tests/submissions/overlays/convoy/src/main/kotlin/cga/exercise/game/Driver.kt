package cga.exercise.game

import cga.exercise.components.geometry.Renderable
import org.joml.Vector3f
import kotlin.math.exp

/** Steers a motorcycle: speed and turning follow what is wanted a little later. */
class Driver(private val cycle: Renderable) {
    var speed = 0.0f
        private set
    private var turning = 0.0f

    fun drive(gas: Float, steer: Float, dt: Float) {
        val blend = 1.0f - exp(-6.0f * dt)
        speed += (gas * TOP_SPEED - speed) * blend
        turning += (steer * speed * 0.25f - turning) * blend
        cycle.rotateLocal(0.0f, turning * dt, 0.0f)
        cycle.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
    }

    companion object {
        const val TOP_SPEED = 7.0f
    }
}

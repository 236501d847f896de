package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.exp

/** Fliegt dem Motorrad etwas verzögert hinterher (Taste C). */
class FollowCamera(private val target: Transformable) : TronCamera() {
    private val position = Vector3f(0.0f, 3.0f, 6.0f)

    fun update(dt: Float) {
        val wanted = target.getWorldZAxis().mul(5.0f).add(target.getWorldPosition()).add(0.0f, 2.5f, 0.0f)
        position.lerp(wanted, 1.0f - exp(-4.0f * dt))
    }

    override fun getCalculateViewMatrix(): Matrix4f =
        Matrix4f().lookAt(position, target.getWorldPosition().add(0.0f, 0.6f, 0.0f), Vector3f(0.0f, 1.0f, 0.0f))
}

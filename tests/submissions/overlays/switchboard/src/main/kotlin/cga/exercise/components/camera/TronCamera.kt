package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f

/** Looks at the origin of its parent, from a direction given by two angles. */
class TronCamera : Transformable(), ICamera {
    private var yaw = 0.0f
    private var pitch = toRadians(-27.0f)
    private val distance = 4.6f

    init {
        place()
    }

    fun orbit(deltaYaw: Float, deltaPitch: Float) {
        yaw += deltaYaw
        pitch = (pitch + deltaPitch).coerceIn(toRadians(-80.0f), toRadians(-5.0f))
        place()
    }

    private fun place() {
        setLocalMatrix(Matrix4f().rotateY(yaw).rotateX(pitch).translate(0.0f, 0.0f, distance))
    }

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        return Matrix4f().lookAt(eye, getWorldZAxis().negate().add(eye), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(toRadians(85.0f), 16.0f / 9.0f, 0.1f, 120.0f)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("uProjection", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera(
    private val fieldOfView: Float = toRadians(90.0f),
    private val aspectRatio: Float = 16.0f / 9.0f,
    private val nearPlane: Float = 0.1f,
    private val farPlane: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val center = getWorldPosition().sub(getWorldZAxis())
        return Matrix4f().lookAt(eye, center, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f =
        Matrix4f().perspective(fieldOfView, aspectRatio, nearPlane, farPlane)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view", getCalculateViewMatrix(), false)
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
    private val fieldOfView: Float = Math.toRadians(90.0f),
    private val aspectRatio: Float = 16.0f / 9.0f,
    private val nearPlane: Float = 0.1f,
    private val farPlane: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val lookingAt = getWorldPosition().sub(getWorldZAxis())
        return Matrix4f().lookAt(eye, lookingAt, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fieldOfView, aspectRatio, nearPlane, farPlane)
    }

    override fun bind(shader: ShaderProgram) {
        // the view matrix is already part of "modelToView", see Renderable
        shader.setUniform("viewToClip", getCalculateProjectionMatrix(), false)
    }
}

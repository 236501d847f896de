package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f

/** A perspective camera; looks along its negative z axis. */
class TronCamera(
    var fieldOfView: Float = toRadians(90.0f),
    var aspectRatio: Float = 16.0f / 9.0f,
    var nearPlane: Float = 0.1f,
    var farPlane: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val lookAtPoint = Vector3f(eye).sub(getWorldZAxis())
        return Matrix4f().lookAt(eye, lookAtPoint, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fieldOfView, aspectRatio, nearPlane, farPlane)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("viewMatrix", getCalculateViewMatrix(), false)
        shader.setUniform("projectionMatrix", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    private val fov: Float = 1.5707964f,
    private val ratio: Float = 16.0f / 9.0f,
    private val nearPlane: Float = 0.1f,
    private val farPlane: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val cameraPos = getWorldPosition()
        val cameraFront = getWorldZAxis().negate()
        val cameraUp = getWorldYAxis()
        return Matrix4f().lookAt(cameraPos, Vector3f(cameraPos).add(cameraFront), cameraUp)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, ratio, nearPlane, farPlane)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view", getCalculateViewMatrix(), false)
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
    }
}

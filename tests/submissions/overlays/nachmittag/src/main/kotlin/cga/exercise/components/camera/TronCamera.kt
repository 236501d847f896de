package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    private val zoom: Float = 80.0f,
    private val aspect: Float = 1280.0f / 720.0f,
    private val near: Float = 0.1f,
    private val far: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val cameraPos = getWorldPosition()
        val cameraFront = getWorldZAxis().negate()
        val cameraUp = getWorldYAxis()
        return Matrix4f().lookAt(cameraPos, Vector3f(cameraPos).add(cameraFront), cameraUp)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(Math.toRadians(zoom), aspect, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("matProj", getCalculateProjectionMatrix(), false)
        shader.setUniform("matView", getCalculateViewMatrix(), false)
    }
}

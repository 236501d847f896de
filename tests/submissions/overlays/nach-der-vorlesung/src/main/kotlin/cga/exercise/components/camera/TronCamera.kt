package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    private val fov: Float = Math.toRadians(90.0f),
    private val aspect: Float = 16.0f / 9.0f,
    private val near: Float = 0.1f,
    private val far: Float = 100.0f
) : Transformable(), ICamera {

    // eye, center, up wie auf der Folie "View-Transformation"; die Kamera schaut in Richtung -z
    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val center = Vector3f(eye).sub(getWorldZAxis())
        val up = getWorldYAxis()
        return Matrix4f().lookAt(eye, center, up)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, aspect, near, far)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("uView", getCalculateViewMatrix(), false)
        shader.setUniform("uProj", getCalculateProjectionMatrix(), false)
    }
}

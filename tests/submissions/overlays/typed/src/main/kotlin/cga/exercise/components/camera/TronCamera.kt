package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(private val fov: Float = toRadians(90.0f), private val ratio: Float = 16.0f / 9.0f) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        return Matrix4f().lookAt(eye, Vector3f(eye).sub(getWorldZAxis()), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, ratio, 0.1f, 100.0f)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("u_view", getCalculateViewMatrix(), false)
        shader.setUniform("u_proj", getCalculateProjectionMatrix(), false)
    }
}

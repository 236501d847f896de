package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera : ICamera, Transformable() {

    val fov: Float = Math.toRadians(90.0f)
    val aspect: Float = 16.0f / 9.0f
    val near: Float = 0.1f
    val far: Float = 100.0f

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val center = getWorldPosition().sub(getWorldZAxis())
        val up = getWorldYAxis()
        return Matrix4f().lookAt(eye, center, up)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, aspect, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("proj_matrix", getCalculateProjectionMatrix(), false)
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
    }
}

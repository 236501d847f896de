package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = toRadians(90.0f),
    var aspect: Float = 16.0f / 9.0f,
    var near: Float = 0.1f,
    var far: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f =
        Matrix4f().lookAt(getWorldPosition(), getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, aspect, near, far)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("projection_matrix", getCalculateProjectionMatrix(), false)
    }
}

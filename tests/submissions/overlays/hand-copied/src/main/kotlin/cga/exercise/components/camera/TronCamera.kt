package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class TronCamera : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val pos = getWorldPosition()
        return Matrix4f().lookAt(pos, getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f =
        Matrix4f().perspective(Math.toRadians(85.0).toFloat(), 16f / 9f, 0.1f, 100f)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("proj_matrix", getCalculateProjectionMatrix(), false)
    }
}

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

    override fun getCalculateViewMatrix(): Matrix4f {
        val position = getWorldPosition()
        return Matrix4f().lookAt(position, getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, aspect, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view", getCalculateViewMatrix(), false)
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
        shader.setUniform("viewPos", getWorldPosition())
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = Math.toRadians(90f),
    var aspect: Float = 16f / 9f,
    var near: Float = 0.1f,
    var far: Float = 100f
) : Transformable(), ICamera {

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
        shader.setUniform("viewMatrix", getCalculateViewMatrix(), false)
        shader.setUniform("projectionMatrix", getCalculateProjectionMatrix(), false)
    }
}

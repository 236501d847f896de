package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera : Transformable(), ICamera {
    private val projection = Matrix4f().perspective(Math.toRadians(90f), 16f / 9f, 0.1f, 100f)

    override fun getCalculateViewMatrix(): Matrix4f {
        val position = getWorldPosition()
        val lookAtPoint = getWorldPosition().sub(getWorldZAxis())
        return Matrix4f().lookAt(position, lookAtPoint, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix() = Matrix4f(projection)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("viewM", getCalculateViewMatrix(), false)
        shader.setUniform("projM", projection, false)
    }
}

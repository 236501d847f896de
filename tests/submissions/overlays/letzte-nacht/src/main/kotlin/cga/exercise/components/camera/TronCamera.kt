package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        //return Matrix4f().lookAt(getWorldPosition(), getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
        return getWorldModelMatrix().invert()
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(Math.toRadians(85.0f), 16.0f / 9.0f, 0.1f, 100.0f)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("vM", getCalculateViewMatrix(), false)
        shader.setUniform("pM", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = Math.toRadians(90.0).toFloat(),
    var aspect: Float = 16.0f / 9.0f,
    var near: Float = 0.1f,
    var far: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val viewMatrix = Matrix4f()
        viewMatrix.lookAt(getWorldPosition(), getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
        return viewMatrix
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        val projectionMatrix = Matrix4f()
        projectionMatrix.perspective(fov, aspect, near, far)
        return projectionMatrix
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("projection_matrix", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Node
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera : Node(), ICamera {
    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        return Matrix4f().lookAt(eye, getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(toRadians(80.0f), 16.0f / 9.0f, 0.1f, 100.0f)

    override fun bind(shader: ShaderProgram) {
        shader.uniforms["matrices.projection"] = getCalculateProjectionMatrix()
    }
}

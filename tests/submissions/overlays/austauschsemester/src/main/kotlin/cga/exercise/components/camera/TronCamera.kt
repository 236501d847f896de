package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = toRadians(90f),
    var aspect: Float = 16f / 9f,
    var near: Float = 0.1f,
    var far: Float = 100f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        return Matrix4f().lookAt(eye, getWorldPosition().sub(getWorldZAxis()), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, aspect, near, far)

    override fun bind(shader: ShaderProgram) =
        shader.send("view" to getCalculateViewMatrix(), "projection" to getCalculateProjectionMatrix())
}

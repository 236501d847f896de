package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera(
    private val fieldOfView: Float = 75.0f, // degrees, like in the inspector
    private val aspect: Float = 16.0f / 9.0f,
    private val nearClip: Float = 0.1f,
    private val farClip: Float = 120.0f
) : Transformable(), ICamera {

    // no scale in here, the bike is scaled and the camera hangs on the bike
    override fun getCalculateViewMatrix(): Matrix4f =
        Matrix4f().translationRotateScale(position, rotation, 1.0f).invert()

    override fun getCalculateProjectionMatrix(): Matrix4f =
        Matrix4f().perspective(toRadians(fieldOfView), aspect, nearClip, farClip)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("_MatrixV", getCalculateViewMatrix(), false)
        shader.setUniform("_MatrixP", getCalculateProjectionMatrix(), false)
    }
}

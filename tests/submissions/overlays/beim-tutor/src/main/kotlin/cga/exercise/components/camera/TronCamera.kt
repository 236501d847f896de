package cga.exercise.components.camera

import cga.exercise.components.geometry.Matrices
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
    private val fov: Float = Math.toRadians(90.0f),
    private val seitenverhaeltnis: Float = 16.0f / 9.0f,
    private val near: Float = 0.1f,
    private val far: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f = Matrices.view(getWorldModelMatrix())

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, seitenverhaeltnis, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("mat_V", getCalculateViewMatrix(), false)
        shader.setUniform("mat_P", getCalculateProjectionMatrix(), false)
    }
}

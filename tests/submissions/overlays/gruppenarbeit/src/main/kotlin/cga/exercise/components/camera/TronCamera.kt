package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.uniforms
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    private val fov: Float = Math.toRadians(85f),
    private val ratio: Float = 16f / 9f,
    private val near: Float = 0.1f,
    private val far: Float = 120f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val forward = getWorldZAxis().negate()
        return Matrix4f().lookAt(eye, Vector3f(eye).add(forward), getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, ratio, near, far)

    override fun bind(shader: ShaderProgram) = shader.uniforms {
        "ansicht" set getCalculateViewMatrix()
        "projektion" set getCalculateProjectionMatrix()
    }
}

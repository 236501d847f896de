package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    private val openingAngle: Float = Math.toRadians(80.0f),
    private val ratio: Float = 16.0f / 9.0f,
    private val near: Float = 0.1f,
    private val far: Float = 100.0f
) : Transformable(), ICamera {

    // Formel 4.1 aus Kapitel 3: M_view = R^-1 * T(-Auge)
    override fun getCalculateViewMatrix(): Matrix4f {
        val eye: Vector3f = getWorldPosition()
        val forward: Vector3f = getWorldZAxis().negate()
        val up: Vector3f = getWorldYAxis()
        return Matrix4f().lookAlong(forward, up).translate(eye.negate())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(openingAngle, ratio, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("worldToView", getCalculateViewMatrix(), false)
        shader.setUniform("viewToClip", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
    private val fov: Float = Math.toRadians(90f),
    private val ratio: Float = 16f / 9f,
    private val nah: Float = 0.1f,
    private val fern: Float = 100f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val blick = getWorldZAxis().negate()
        val oben = getWorldYAxis()
        val ort = getWorldPosition()
        return Matrix4f().lookAlong(blick, oben).translate(ort.negate())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, ratio, nah, fern)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("toView", getCalculateViewMatrix(), false)
        shader.setUniform("toScreen", getCalculateProjectionMatrix(), false)
    }
}

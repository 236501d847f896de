package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    var sichtfeld: Float = Math.toRadians(90.0f),
    var seitenverhaeltnis: Float = 16.0f / 9.0f,
    var nah: Float = 0.1f,
    var fern: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val auge = getWorldPosition()
        val ziel = Vector3f(auge).sub(getWorldZAxis())
        return Matrix4f().lookAt(auge, ziel, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(sichtfeld, seitenverhaeltnis, nah, fern)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("viewMatrix", getCalculateViewMatrix(), false)
        shader.setUniform("projectionMatrix", getCalculateProjectionMatrix(), false)
    }
}

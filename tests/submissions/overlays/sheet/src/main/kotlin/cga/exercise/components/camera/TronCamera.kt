package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera : Transformable(), ICamera {
    private val fov = Math.toRadians(90.0f)
    private val seitenverhaeltnis = 16.0f / 9.0f
    private val nah = 0.1f
    private val fern = 100.0f

    override fun getCalculateViewMatrix(): Matrix4f {
        val auge = getWorldPosition()
        val ziel = Vector3f(auge).sub(getWorldZAxis())
        return Matrix4f().lookAt(auge, ziel, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, seitenverhaeltnis, nah, fern)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("projection_matrix", getCalculateProjectionMatrix(), false)
    }
}

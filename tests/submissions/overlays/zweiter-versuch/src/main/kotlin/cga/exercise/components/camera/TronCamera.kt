package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = Math.toRadians(90f),
    var seitenverhaeltnis: Float = 16f / 9f,
    var near: Float = 0.1f,
    var far: Float = 100f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val center = getWorldPosition().add(blickrichtung())
        return Matrix4f().lookAt(eye, center, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, seitenverhaeltnis, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("viewMat", getCalculateViewMatrix(), false)
        shader.setUniform("projMat", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    var fieldOfView: Float = toRadians(90.0f),
    var aspect: Float = 16.0f / 9.0f,
    var nah: Float = 0.1f,
    var fern: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val wo = getWorldPosition()
        val hinten = getWorldZAxis().normalize()
        val ziel = Vector3f(wo).sub(hinten)
        val oben = getWorldYAxis().normalize()
        val view = Matrix4f()
        view.lookAt(wo, ziel, oben)
        return view
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        val projection = Matrix4f()
        projection.perspective(fieldOfView, aspect, nah, fern)
        return projection
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("projection_matrix", getCalculateProjectionMatrix(), false)
    }
}

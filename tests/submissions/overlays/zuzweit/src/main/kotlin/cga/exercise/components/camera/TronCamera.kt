package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = Math.toRadians(80.0f),
    var seitenverhaeltnis: Float = 16.0f / 9.0f,
    var nah: Float = 0.1f,
    var fern: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val auge = getWorldPosition()
        val ziel = getWorldPosition().sub(getWorldZAxis())
        return Matrix4f().lookAt(auge, ziel, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, seitenverhaeltnis, nah, fern)

    // die View steckt bei uns schon in der ModelView der Objekte (siehe Renderable)
    override fun bind(shader: ShaderProgram) {
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
    }
}

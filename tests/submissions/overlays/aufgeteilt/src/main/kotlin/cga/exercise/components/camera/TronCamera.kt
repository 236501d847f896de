package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(
    var oeffnungswinkel: Float = Math.toRadians(90.0f),
    var seitenverhaeltnis: Float = 16.0f / 9.0f,
    var nah: Float = 0.1f,
    var fern: Float = 100.0f
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val auge = getWorldPosition()
        val ziel = auge.sub(getWorldZAxis(), Vector3f())
        return Matrix4f().lookAt(auge, ziel, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().setPerspective(oeffnungswinkel, seitenverhaeltnis, nah, fern)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("proj_matrix", getCalculateProjectionMatrix(), false)
    }

    /** Dreht die Kamera um das Elternobjekt (Ursprung des Elternsystems). */
    fun umkreisen(winkel: Float) {
        rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera : Transformable(), ICamera {
    var fov = Math.toRadians(80.0).toFloat()
    var asp = 16.0f / 9.0f
    var near = 0.1f
    var far = 100.0f

    override fun getCalculateViewMatrix(): Matrix4f {
        val auge = getWorldPosition()
        val ziel = Vector3f(auge).sub(getWorldZAxis())
        // return getWorldModelMatrix().invert()   // bild war irgendwie gestaucht??
        return Matrix4f().lookAt(auge, ziel, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, asp, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("vm", getCalculateViewMatrix(), false)
        shader.setUniform("pm", getCalculateProjectionMatrix(), false)
    }
}

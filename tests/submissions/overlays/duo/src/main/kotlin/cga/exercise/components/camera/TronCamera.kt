package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera(var fov : Float = Math.toRadians(90f),
                 var aspect : Float = 16f/9f,
                 var zNear : Float = 0.1f,
                 var zFar : Float = 100f) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val center = Vector3f()
        eye.sub(getWorldZAxis(), center)
        val up = getWorldYAxis()
        return Matrix4f().lookAt(eye, center, up)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, aspect, zNear, zFar)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("u_proj", getCalculateProjectionMatrix(), false)
        shader.setUniform("u_view", getCalculateViewMatrix(), false)
    }
}

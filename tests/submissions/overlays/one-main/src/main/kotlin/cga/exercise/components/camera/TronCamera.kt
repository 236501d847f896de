package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera : Transformable(), ICamera {
    var fov = Math.toRadians(90.0).toFloat()
    var aspect = 16.0f / 9.0f
    var near = 0.1f
    var far = 100.0f

    override fun getCalculateViewMatrix(): Matrix4f {
        val view = Matrix4f()
        val pos = getWorldPosition()
        val z = getWorldZAxis()
        val center = Vector3f(pos.x - z.x, pos.y - z.y, pos.z - z.z)
        view.lookAt(pos, center, getWorldYAxis())
        return view
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, aspect, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("projection_matrix", getCalculateProjectionMatrix(), false)
    }
}

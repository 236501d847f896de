package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera : Transformable(), ICamera {

    var fov = Math.toRadians(90f)
    var ratio = 16f / 9f
    var near = 0.1f
    var far = 100f

    override fun getCalculateViewMatrix(): Matrix4f {
        val view = Matrix4f()
        val eye = getWorldPosition()
        val center = Vector3f(eye).sub(getWorldZAxis())
        view.lookAt(eye, center, getWorldYAxis())
        return view
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        val proj = Matrix4f()
        proj.perspective(fov, ratio, near, far)
        return proj
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view_matrix", getCalculateViewMatrix(), false)
        shader.setUniform("proj_matrix", getCalculateProjectionMatrix(), false)
    }
}

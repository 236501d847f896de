package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.set
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera(
    var fov: Float = toRadians(80.0f),
    var aspect: Float = 16.0f / 9.0f,
    var near: Float = 0.1f,
    var far: Float = 150.0f
) : Transformable(), ICamera {

    // the bike is scaled, so the scale has to go out of the chain before inverting
    override fun getCalculateViewMatrix(): Matrix4f = world.normalize3x3().invertAffine()

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, aspect, near, far)

    override fun bind(shader: ShaderProgram) {
        shader["u_view"] = getCalculateViewMatrix()
        shader["u_proj"] = getCalculateProjectionMatrix()
    }
}

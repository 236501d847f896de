package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class TronCamera(
    private val fovY: Float,
    private val aspect: Float,
    private val near: Float,
    private val far: Float
) : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        // Achsen sind normiert, daher ist die Inverse der Drehung = Transponierte
        val x = getWorldXAxis()
        val y = getWorldYAxis()
        val z = getWorldZAxis()
        val p = getWorldPosition()
        return Matrix4f(
            x.x, y.x, z.x, 0.0f,
            x.y, y.y, z.y, 0.0f,
            x.z, y.z, z.z, 0.0f,
            -x.dot(p), -y.dot(p), -z.dot(p), 1.0f
        )
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().setPerspective(fovY, aspect, near, far)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("u_view", getCalculateViewMatrix(), false)
        shader.setUniform("u_proj", getCalculateProjectionMatrix(), false)
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f

class TronCamera : Transformable(), ICamera {
    private val projection = Matrix4f().setPerspective(toRadians(85f), 16f / 9f, 0.1f, 100f)

    override fun getCalculateViewMatrix(): Matrix4f = getWorldRigidMatrix().invert()

    override fun getCalculateProjectionMatrix(): Matrix4f = projection

    override fun bind(shader: ShaderProgram) {
        val viewProjection = Matrix4f(projection).mul(getCalculateViewMatrix())
        shader.setMat4("u_ViewProjection", viewProjection)
        shader.setVec3("u_CameraPosition", getWorldPosition())
    }

    /** Turns the camera round the origin of its parent. */
    fun orbit(angle: Float) {
        rotateAroundPoint(0f, angle, 0f, Vector3f(0f, 0f, 0f))
    }

    // the axes may be scaled by the parent
    private fun getWorldRigidMatrix(): Matrix4f {
        val p = getWorldPosition()
        val x = getWorldXAxis()
        val y = getWorldYAxis()
        val z = getWorldZAxis()
        return Matrix4f(
            x.x, x.y, x.z, 0f,
            y.x, y.y, y.z, 0f,
            z.x, z.y, z.z, 0f,
            p.x, p.y, p.z, 1f
        )
    }
}

package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f

/** Follows [target] and can be turned around it. */
class OrbitCamera(private val target: Transformable, private val distance: Float, private val height: Float) : ICamera {
    var yaw = 0.0f
    private val fov = toRadians(85.0f)

    fun eye(): Vector3f {
        val offset = Vector3f(0.0f, height, distance).rotateY(yaw)
        return target.getWorldModelMatrix().transformPosition(offset)
    }

    override fun getCalculateViewMatrix(): Matrix4f =
        Matrix4f().lookAt(eye(), target.getWorldPosition().add(0.0f, 0.6f, 0.0f), Vector3f(0.0f, 1.0f, 0.0f))

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(fov, 16.0f / 9.0f, 0.1f, 150.0f)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view", getCalculateViewMatrix(), false)
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
    }
}

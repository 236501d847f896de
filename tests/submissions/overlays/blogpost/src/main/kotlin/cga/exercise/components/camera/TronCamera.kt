package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos
import kotlin.math.sin

/** Circles around its target. */
class TronCamera(
    private val target: Transformable,
    private val radius: Float = 5.0f,
    private val height: Float = 2.8f,
    private val fov: Float = toRadians(75.0f),
    private val aspect: Float = 16.0f / 9.0f
) : Transformable(), ICamera {
    var yaw = 0.0f

    private val worldUp = Vector3f(0.0f, 1.0f, 0.0f)

    fun eyePosition(): Vector3f {
        val camX = sin(yaw) * radius
        val camZ = cos(yaw) * radius
        return target.getWorldModelMatrix().transformPosition(Vector3f(camX, height, camZ))
    }

    override fun getCalculateViewMatrix(): Matrix4f {
        val center = target.getWorldPosition().add(0.0f, 0.6f, 0.0f)
        return Matrix4f().lookAt(eyePosition(), center, worldUp)
    }

    override fun getCalculateProjectionMatrix(): Matrix4f {
        return Matrix4f().perspective(fov, aspect, 0.1f, 100.0f)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
        shader.setUniform("view", getCalculateViewMatrix(), false)
        shader.setUniform("viewPos", eyePosition())
    }
}

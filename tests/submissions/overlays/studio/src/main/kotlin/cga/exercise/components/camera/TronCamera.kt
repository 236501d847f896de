package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.UniformBlock
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos
import kotlin.math.sin

/** Looks at [target] from a sphere about it; [yaw] goes around it. */
class TronCamera(private val target: Transformable) : ICamera {
    var yaw = 0.0f
    var pitch = toRadians(30.0f)
    var radius = 5.0f
    var aspect = 16.0f / 9.0f

    override fun getCalculateViewMatrix(): Matrix4f {
        val onSphere = Vector3f(sin(yaw) * cos(pitch), sin(pitch), cos(yaw) * cos(pitch)).mul(radius)
        val world = target.getWorldModelMatrix()
        val center = world.transformPosition(Vector3f(0.0f, 0.5f, 0.0f))
        val eye = world.transformPosition(onSphere.add(0.0f, 0.5f, 0.0f))
        return Matrix4f().lookAt(eye, center, Vector3f(0.0f, 1.0f, 0.0f))
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(toRadians(75.0f), aspect, 0.1f, 100.0f)

    override fun bind(block: UniformBlock) {
        block.put(0, getCalculateViewMatrix())
        block.put(64, getCalculateProjectionMatrix())
        block.send()
    }
}

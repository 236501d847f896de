package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f

/** Looks at its target from a sphere around it, and goes along with it. */
class OrbitCamera(
    private val target: Transformable,
    private val distance: Float = 4.2f,
    private val elevation: Float = toRadians(32.0f)
) : ICamera {

    private var azimuth = 0.0f

    fun orbit(angle: Float) {
        azimuth += angle
    }

    private fun eye(): Vector3f {
        val offset = Vector3f(0.0f, 0.0f, distance).rotateX(-elevation).rotateY(azimuth)
        return target.getWorldModelMatrix().transformPosition(offset)
    }

    override fun getCalculateViewMatrix(): Matrix4f = Matrix4f().lookAt(eye(), target.getWorldPosition(), UP)

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(FIELD_OF_VIEW, ASPECT_RATIO, NEAR, FAR)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("view", getCalculateViewMatrix(), false)
        shader.setUniform("projection", getCalculateProjectionMatrix(), false)
    }

    private companion object {
        val UP = Vector3f(0.0f, 1.0f, 0.0f)
        val FIELD_OF_VIEW = toRadians(80.0f)
        const val ASPECT_RATIO = 16.0f / 9.0f
        const val NEAR = 0.1f
        const val FAR = 100.0f
    }
}

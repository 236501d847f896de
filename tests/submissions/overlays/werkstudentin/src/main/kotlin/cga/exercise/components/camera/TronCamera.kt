package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.degrees
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/** Follows its [target] and can be turned around it. */
class TronCamera(
    target: Transformable,
    distance: Float = 5f,
    elevation: Float = 30.degrees,
    private val lens: Lens = Lens()
) : Transformable(parent = target), ICamera {

    data class Lens(
        val fieldOfView: Float = 75.degrees,
        val aspectRatio: Float = 16f / 9f,
        val near: Float = 0.1f,
        val far: Float = 100f
    )

    init {
        rotate(-elevation, 0f, 0f)
        translate(Vector3f(0f, 0f, distance))
    }

    /** The target is the origin of the space in which the camera lives. */
    fun orbit(yaw: Float) = rotateAroundPoint(0f, yaw, 0f, Vector3f())

    override fun getCalculateViewMatrix(): Matrix4f {
        val eye = getWorldPosition()
        val ahead = getWorldPosition().sub(getWorldZAxis())
        return Matrix4f().lookAt(eye, ahead, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = with(lens) {
        Matrix4f().perspective(fieldOfView, aspectRatio, near, far)
    }

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("viewFromWorld", getCalculateViewMatrix(), false)
        shader.setUniform("clipFromView", getCalculateProjectionMatrix(), false)
    }
}

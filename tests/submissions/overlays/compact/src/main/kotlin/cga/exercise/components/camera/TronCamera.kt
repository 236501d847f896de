package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.setAll
import org.joml.Matrix4f
import org.joml.Quaternionf

/** Where the camera is, as seen from what it looks at (radians). */
data class Orbit(val yaw: Float = 0f, val pitch: Float = 0.55f, val distance: Float = 3.6f) {
    fun turned(angle: Double) = copy(yaw = yaw + angle.toFloat())
}

class TronCamera(private val target: Transformable) : ICamera {
    var orbit = Orbit()

    override fun getCalculateViewMatrix(): Matrix4f = target.getWorldModelMatrix().let { world ->
        Matrix4f()
            .translate(0f, 0f, -orbit.distance)
            .rotateX(orbit.pitch)
            .rotateY(orbit.yaw)
            .rotate(world.getUnnormalizedRotation(Quaternionf()).invert())
            .translate(target.getWorldPosition().negate())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(FIELD_OF_VIEW, ASPECT, NEAR, FAR)

    override fun bind(shader: ShaderProgram) =
        shader.setAll("view" to getCalculateViewMatrix(), "projection" to getCalculateProjectionMatrix())

    companion object {
        const val FIELD_OF_VIEW = 1.5f
        const val ASPECT = 16f / 9f
        const val NEAR = 0.1f
        const val FAR = 120f
    }
}

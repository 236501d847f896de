package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.struct
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import kotlin.math.cos

/** Both angles in radians, measured from the axis. */
data class Cone(val inner: Float, val outer: Float) {
    val cosines get() = Vector2f(cos(inner), cos(outer))
}

/** Shines along -z. */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    intensity: Float,
    private val cone: Cone
) : PointLight(position, color, intensity, "headlamp"), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        bind(shaderProgram)
        shaderProgram.struct("headlamp") {
            "axis" set viewMatrix.transformDirection(getWorldZAxis().negate())
            "cone" set cone.cosines
        }
    }
}

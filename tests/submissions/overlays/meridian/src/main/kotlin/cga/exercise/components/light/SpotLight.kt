package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

/** Shines along its negative z axis. Both angles in radians, from the axis to the edge of the cone. */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, color, Attenuation.SPOT), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, "$name.source")
        val direction = viewMatrix.transformDirection(getWorldZAxis().negate())
        shaderProgram.setUniform("$name.direction", direction)
        shaderProgram.setUniform("$name.cosInner", cos(innerAngle))
        shaderProgram.setUniform("$name.cosOuter", cos(outerAngle))
    }
}

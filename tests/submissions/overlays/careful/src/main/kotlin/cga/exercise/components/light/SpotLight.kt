package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

/**
 * A light with a direction: it shines along its negative z axis.
 *
 * @param innerAngle gamma, in radians
 * @param outerAngle phi, in radians
 */
class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, lightColor), ISpotLight {

    override val attenuation = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        shaderProgram.setUniform(name + "Position", getWorldPosition())
        shaderProgram.setUniform("$name.color", lightColor)
        shaderProgram.setUniform("$name.attenuation", attenuation)
        shaderProgram.setUniform("$name.direction", directionInViewSpace(viewMatrix))
        // the cosines are the same for all fragments
        shaderProgram.setUniform("$name.cosInner", cos(innerAngle))
        shaderProgram.setUniform("$name.cosOuter", cos(outerAngle))
    }

    /** A direction is only turned, not moved. */
    private fun directionInViewSpace(viewMatrix: Matrix4f): Vector3f {
        val worldDirection = getWorldZAxis().negate()
        return worldDirection.mul(Matrix3f(viewMatrix))
    }
}

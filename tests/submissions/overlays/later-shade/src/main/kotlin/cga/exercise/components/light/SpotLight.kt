package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/**
 * @param innerCone angle of the inner cone in degrees
 * @param outerCone angle of the outer cone in degrees
 */
class SpotLight(
    lightPos: Vector3f,
    lightCol: Vector3f,
    lightName: String,
    innerCone: Float,
    outerCone: Float
) : PointLight(lightPos, lightCol, lightName), ISpotLight {

    private val cone = Vector2f(Math.toRadians(innerCone), Math.toRadians(outerCone))

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        super.bind(shaderProgram)
        shaderProgram.setUniform("$lightName.cone", cone)
        shaderProgram.setUniform("$lightName.dir", getWorldZAxis().negate().mul(Matrix3f(viewMatrix)))
    }
}

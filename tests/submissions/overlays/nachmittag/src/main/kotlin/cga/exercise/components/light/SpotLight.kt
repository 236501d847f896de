package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/** The angles are in radians and measured from the middle of the cone. */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val cutOff: Float,
    private val outerCutOff: Float
) : PointLight(position, color, 0.5f, 0.05f, 0.01f), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)

        // the light looks along -z, like the camera
        val front = getWorldZAxis().negate()
        val viewDirection = viewMatrix.transformDirection(front, Vector3f())
        shaderProgram.setUniform("$name.viewDirection", viewDirection)

        shaderProgram.setUniform("$name.cutOffAngle", cutOff)
        shaderProgram.setUniform("$name.outerCutOffAngle", outerCutOff)
    }
}

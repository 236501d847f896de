package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

/**
 * @param cutOff angle of the inner cone (radians)
 * @param outerCutOff angle of the outer cone (radians)
 */
class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val cutOff: Float,
    private val outerCutOff: Float
) : PointLight(position, color, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val direction = viewMatrix.transformDirection(getWorldZAxis().mul(-1.0f))
        shaderProgram.setUniform("$name.direction", direction)
        // cosines, so that the shader does not have to calculate them for every fragment
        shaderProgram.setUniform("$name.cutOff", cos(cutOff))
        shaderProgram.setUniform("$name.outerCutOff", cos(outerCutOff))
    }
}

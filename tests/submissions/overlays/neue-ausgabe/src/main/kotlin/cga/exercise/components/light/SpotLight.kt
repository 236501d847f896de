package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

// Winkel in Radiant
class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, lightColor), ISpotLight {

    // kein super.bind(), das würde die Werte vom PointLight überschreiben
    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        shaderProgram.setUniform("spotLightPosition", getWorldPosition())
        shaderProgram.setUniform("spotLightColor", lightColor)

        // leuchtet in Richtung -z, Richtung muss in den View Space
        val direction = getWorldZAxis().negate()
        direction.mulDirection(viewMatrix)
        shaderProgram.setUniform("spotLightDirection", direction)

        shaderProgram.setUniform("spotLightInnerAngle", innerAngle)
        shaderProgram.setUniform("spotLightOuterAngle", outerAngle)
    }
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    position: Vector3f,
    lichtfarbe: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, lichtfarbe), ISpotLight {

    // kein super.bind(), der Spot hat seine eigenen Uniforms
    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        // schon im Viewspace
        val posView = viewMatrix.transformPosition(getWorldPosition())
        val richtungView = viewMatrix.transformDirection(blickrichtung())

        shaderProgram.setUniform("spotPosition", posView)
        shaderProgram.setUniform("spotRichtung", richtungView)
        shaderProgram.setUniform("spotFarbe", lichtfarbe)
        shaderProgram.setUniform("spotCosInnen", Math.cos(innerAngle))
        shaderProgram.setUniform("spotCosAussen", Math.cos(outerAngle))
    }
}

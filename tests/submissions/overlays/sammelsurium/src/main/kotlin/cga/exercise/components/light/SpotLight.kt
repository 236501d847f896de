package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f
import kotlin.math.cos

/**
 * @param cutOff inner angle in radians
 * @param outerCutOff outer angle in radians
 */
class SpotLight(position: Vector3f, lightColor: Vector3f, private val cutOff: Float, private val outerCutOff: Float) : PointLight(position, lightColor), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        // w = 0, because it is a direction
        val richtung = Vector4f(getWorldZAxis().negate(), 0.0f)
        viewMatrix.transform(richtung)

        shaderProgram.setUniform("spotLight.position", getWorldPosition())
        shaderProgram.setUniform("spotLight.direction", Vector3f(richtung.x, richtung.y, richtung.z))
        shaderProgram.setUniform("spotLight.color", lightColor)
        shaderProgram.setUniform("spotLight.cutOff", cos(cutOff))
        shaderProgram.setUniform("spotLight.outerCutOff", cos(outerCutOff))
    }
}

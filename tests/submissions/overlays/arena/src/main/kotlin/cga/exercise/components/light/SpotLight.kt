package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, lightColor, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        val dir = getWorldZAxis().negate()
        viewMatrix.transformDirection(dir)
        shaderProgram.setUniform("${name}Position", getWorldPosition())
        shaderProgram.setUniform("${name}Color", lightColor)
        shaderProgram.setUniform("${name}Attenuation", attenuation)
        shaderProgram.setUniform("${name}Direction", dir)
        shaderProgram.setUniform("${name}Cone", Vector2f(cos(innerAngle), cos(outerAngle)))
    }
}

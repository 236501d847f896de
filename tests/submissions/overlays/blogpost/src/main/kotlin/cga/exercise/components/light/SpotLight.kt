package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val cutOff: Float,
    private val outerCutOff: Float
) : PointLight(position, lightColor), ISpotLight {

    init {
        attParams = Vector3f(0.5f, 0.05f, 0.01f)
    }

    // the shader calculates everything in world space, so the view matrix is not needed here
    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val direction = getWorldZAxis().negate()
        shaderProgram.setUniform("$name.direction", direction)
        shaderProgram.setUniform("$name.cutOff", cos(cutOff))
        shaderProgram.setUniform("$name.outerCutOff", cos(outerCutOff))
    }
}

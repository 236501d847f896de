package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(
    position: Vector3f,
    color: Vector3f,
    private val cutOff: Float,
    private val outerCutOff: Float
) : PointLight(position, color), ISpotLight {

    init {
        k = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        shaderProgram.setUniform("$name.direction", getWorldZAxis().negate())
        shaderProgram.setUniform("$name.cutOff", cos(cutOff))
        shaderProgram.setUniform("$name.outerCutOff", cos(outerCutOff))
    }
}

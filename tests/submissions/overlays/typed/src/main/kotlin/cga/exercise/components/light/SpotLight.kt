package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight(position: Vector3f, color: Vector3f, private val inner: Float, private val outer: Float) :
    PointLight(position, color, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {
    override val type = 1

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bindCommon(shaderProgram, name)
        shaderProgram.setUniform("$name.direction", getWorldZAxis().negate())
        shaderProgram.setUniform("$name.cone", Vector2f(inner, outer))
    }
}

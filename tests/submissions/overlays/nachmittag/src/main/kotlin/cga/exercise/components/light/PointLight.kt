package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    var color: Vector3f,
    private val constant: Float = 1.0f,
    private val linear: Float = 0.5f,
    private val quadratic: Float = 0.1f
) : Transformable(), IPointLight {

    init {
        translateGlobal(position)
    }

    // the shader multiplies the position with the view matrix
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.worldPosition", getWorldPosition())
        shaderProgram.setUniform("$name.color", color)
        shaderProgram.setUniform("$name.constant", constant)
        shaderProgram.setUniform("$name.linear", linear)
        shaderProgram.setUniform("$name.quadratic", quadratic)
    }
}

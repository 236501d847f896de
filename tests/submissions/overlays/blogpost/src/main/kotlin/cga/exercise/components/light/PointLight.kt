package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {
    // x = constant, y = linear, z = quadratic
    protected var attParams = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.position", getWorldPosition())
        shaderProgram.setUniform("$name.color", lightColor)
        shaderProgram.setUniform("$name.constant", attParams.x)
        shaderProgram.setUniform("$name.linear", attParams.y)
        shaderProgram.setUniform("$name.quadratic", attParams.z)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, val lightColor: Vector3f) : Transformable(), IPointLight {
    var attenuation = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "Pos", getWorldPosition())
        shaderProgram.setUniform(name + "Color", lightColor)
        shaderProgram.setUniform(name + "Att", attenuation)
    }
}

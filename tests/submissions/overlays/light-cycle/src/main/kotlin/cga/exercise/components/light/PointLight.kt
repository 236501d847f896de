package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(val name: String, var lightColor: Vector3f, position: Vector3f) : Transformable(), IPointLight {

    // K_c, K_l, K_q: inverse square law, the linear hack is no longer needed with gamma
    var attParam = Vector3f(0.0f, 0.0f, 1.0f)

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform(name + "LightPos", getWorldPosition())
        shaderProgram.setUniform(name + "LightColor", lightColor)
        shaderProgram.setUniform(name + "LightAtt", attParam)
    }
}

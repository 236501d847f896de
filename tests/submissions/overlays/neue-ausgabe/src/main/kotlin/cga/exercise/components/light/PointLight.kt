package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("pointLightPosition", getWorldPosition())
        shaderProgram.setUniform("pointLightColor", lightColor)
    }
}

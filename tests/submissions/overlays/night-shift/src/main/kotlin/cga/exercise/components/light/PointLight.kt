package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, var color: Vector3f, protected val index: Int) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("pointLight[$index].pos", getWorldPosition())
        shaderProgram.setUniform("pointLight[$index].color", color)
    }
}

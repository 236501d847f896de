package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f,
                      var lightColor: Vector3f,
                      protected val name: String) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform(name + "_position", getWorldPosition())
        shaderProgram.setUniform(name + "_color", lightColor)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(var color: Vector3f, position: Vector3f, private val id: String = "point") : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform(id + "_pos", getWorldPosition())
        shaderProgram.setUniform(id + "_color", color)
    }

    /** for the lights that are an array in the shader */
    fun bind(shaderProgram: ShaderProgram, index: Int) {
        shaderProgram.setUniform("corner_pos[$index]", getWorldPosition())
        shaderProgram.setUniform("corner_color[$index]", color)
    }
}

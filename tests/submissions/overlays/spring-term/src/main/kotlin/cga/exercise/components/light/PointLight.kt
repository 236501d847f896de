package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** [slot] is the place of the light in the arrays of the shader. */
open class PointLight(position: Vector3f, val color: Vector3f, private val slot: Int) : Transformable(), IPointLight {

    init {
        preTranslate(position)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("lightPos[$slot]", getWorldPosition())
        shaderProgram.setUniform("lightCol[$slot]", color)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * @param slot place of this light in the arrays of the shaders
 */
open class PointLight(
    lightPos: Vector3f,
    val lightColor: Vector3f,
    private val slot: Int,
    private val intensity: Float = 1f
) : Transformable(), IPointLight {

    init {
        preTranslate(lightPos)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("lightPosition[$slot]", getWorldPosition())
        shaderProgram.setUniform("lightColor[$slot]", Vector3f(lightColor).mul(intensity))
    }
}

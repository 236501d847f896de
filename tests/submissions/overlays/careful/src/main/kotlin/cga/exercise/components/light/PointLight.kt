package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * A light that shines in all directions.
 *
 * @param position where it is, in world space or in the space of its parent
 * @param lightColor what it shines with, may be more than 1
 */
open class PointLight(position: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {

    /** K_c, K_l, K_q of table 1. */
    protected open val attenuation: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    /** [name] is the index in the arrays of the shader. */
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("pointLightPositions[$name]", getWorldPosition())
        shaderProgram.setUniform("pointLightColors[$name]", lightColor)
        shaderProgram.setUniform("pointLightAttenuations[$name]", attenuation)
    }

    companion object {
        /** Size of the arrays in the shaders. */
        const val MAX_POINT_LIGHTS = 8
    }
}

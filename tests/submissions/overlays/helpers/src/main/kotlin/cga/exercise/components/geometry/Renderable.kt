package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * Some meshes that are drawn together.
 */
class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {
    /** The texture for the emission is multiplied by this. */
    var emissionColor = Vector3f(1.0f, 1.0f, 1.0f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emissionColor", emissionColor)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

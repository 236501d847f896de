package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

/**
 * Extends Transformable to allow easy handling of 3D objects
 */
class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    /** Renders all meshes attached to this Renderable. Assumes that the shader is in use. */
    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

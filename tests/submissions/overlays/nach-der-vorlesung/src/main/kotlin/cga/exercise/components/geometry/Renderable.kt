package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("uModel", getWorldModelMatrix(), false)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}

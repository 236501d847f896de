package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
        meshes.forEach { m -> m.render(shaderProgram) }
    }

    fun cleanup() {
        for (m in meshes) m.cleanup()
    }
}

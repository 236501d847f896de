package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model", getWorldModelMatrix(), false)
        for (mesh in meshes) mesh.render(shaderProgram)
    }

    fun cleanup() {
        for (mesh in meshes) mesh.cleanup()
    }
}

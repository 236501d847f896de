package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

/** Meshes that have a common place in the world. */
class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("modelMatrix", getWorldModelMatrix(), false)
        for (mesh in meshes) {
            mesh.render(shaderProgram)
        }
    }

    fun cleanup() {
        for (mesh in meshes) {
            mesh.cleanup()
        }
    }
}

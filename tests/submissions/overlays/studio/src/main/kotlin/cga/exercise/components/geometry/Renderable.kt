package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(program: ShaderProgram) {
        program.setUniform("model", getWorldModelMatrix())
        meshes.forEach { it.render(program) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, farbe: Vector3f) {
        shaderProgram.setUniform("model", getWorldModelMatrix(), false)
        shaderProgram.setUniform("farbe", farbe)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

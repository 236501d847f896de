package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("toWorld", getWorldModelMatrix(), false)
        for (m in meshes) {
            m.render(shaderProgram)
        }
    }

    // Blatt 4: mit Farbe fuer die Emission
    fun render(shaderProgram: ShaderProgram, farbe: Vector3f) {
        shaderProgram.setUniform("glowTint", farbe)
        render(shaderProgram)
    }

    fun cleanup() {
        meshes.forEach(Mesh::cleanup)
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    // 4.4, weiss = Textur bleibt wie sie ist
    var glowTint = Vector3f(1.0f, 1.0f, 1.0f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("objectToWorld", getWorldModelMatrix(), false)
        shaderProgram.setUniform("glowTint", glowTint)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

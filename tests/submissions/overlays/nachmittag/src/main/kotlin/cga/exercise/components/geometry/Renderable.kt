package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {
    // colour of the glowing parts
    var emissionTint = Vector3f(1.0f, 1.0f, 1.0f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("matModel", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emissionTint", emissionTint)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    /** The colour in which the emissive parts shine (4.4). */
    var tint = Vector3f(1f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("worldFromModel", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emissionTint", tint)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() = meshes.forEach(Mesh::cleanup)
}

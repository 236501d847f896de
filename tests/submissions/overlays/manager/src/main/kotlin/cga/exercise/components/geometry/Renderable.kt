package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {
    var emissionColor = Vector3f(1f)

    fun render(shader: ShaderProgram) {
        shader.setMat4("u_Model", getWorldModelMatrix())
        shader.setVec3("u_EmissionColor", emissionColor)
        meshes.forEach { it.render(shader) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}

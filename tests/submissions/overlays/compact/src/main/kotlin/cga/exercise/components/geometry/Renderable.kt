package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.set
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shader: ShaderProgram, glow: Vector3f) {
        shader["glow"] = glow
        shader["model"] = getWorldModelMatrix()
        meshes.forEach { it.render(shader) }
    }

    fun cleanup() = meshes.forEach(Mesh::cleanup)
}

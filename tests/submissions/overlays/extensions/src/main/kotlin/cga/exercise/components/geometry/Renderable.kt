package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import cga.exercise.components.shader.times
import org.joml.Matrix4f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, view: Matrix4f) {
        val modelView = view * getWorldModelMatrix()
        shaderProgram.send(
            "modelView" to modelView,
            "normalMatrix" to modelView.normal(Matrix4f())
        )
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() = meshes.forEach(Mesh::cleanup)
}

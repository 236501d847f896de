package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, V: Matrix4f) {
        val MV = Matrices.modelView(V, getWorldModelMatrix())
        shaderProgram.setUniform("mat_MV", MV, false)
        shaderProgram.setUniform("mat_N", Matrices.normalMatrix(MV), false)
        for (mesh in meshes) {
            mesh.render(shaderProgram)
        }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

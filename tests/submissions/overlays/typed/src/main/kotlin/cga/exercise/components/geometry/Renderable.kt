package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, view: Matrix4f) {
        val world = getWorldModelMatrix()
        val normalMatrix = view.mul(world, Matrix4f()).normal(Matrix3f())
        shaderProgram.setUniform("u_model", world, false)
        shaderProgram.setUniform("u_normal", normalMatrix)
        for (mesh in meshes) {
            mesh.render(shaderProgram)
        }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.send
import org.joml.Matrix4f
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, view: Matrix4f, neon: Vector3f) {
        val model = getWorldModelMatrix()
        val modelView = Matrix4f(view).mul(model)
        val normals = Matrix4f(modelView).invert().transpose()

        shaderProgram.send("modelView" to modelView, "normals" to normals, "neon" to neon)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}

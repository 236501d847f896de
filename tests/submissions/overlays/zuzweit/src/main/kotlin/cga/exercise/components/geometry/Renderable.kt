package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    var emissionsFarbe = Vector3f(1.0f)

    fun render(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        val modelView = Matrix4f(viewMatrix).mul(getWorldModelMatrix())
        shaderProgram.setUniform("modelView", modelView, false)
        shaderProgram.setUniform("emissionsFarbe", emissionsFarbe)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        // einmal je Objekt auf der CPU statt einmal je Vertex auf der GPU
        val modelView = Matrix4f(viewMatrix).mul(getWorldModelMatrix())
        val normalMat = Matrix4f(modelView).invert().transpose()
        shaderProgram.setUniform("u_modelView", modelView, false)
        shaderProgram.setUniform("u_normalMat", normalMat, false)

        for (i in 0 until meshes.size) {
            meshes[i].render(shaderProgram)
        }
    }

    fun cleanup() {
        for (i in 0 until meshes.size) {
            meshes[i].cleanup()
        }
    }
}

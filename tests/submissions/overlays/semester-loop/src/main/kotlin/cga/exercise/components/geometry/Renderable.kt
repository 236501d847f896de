package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, emissionColor: Vector3f) {
        shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emissionColor", emissionColor)
        for (m in meshes) {
            m.render(shaderProgram)
        }
    }

    fun cleanup() {
        for (m in meshes) {
            m.cleanup()
        }
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, emitColor: Vector3f) {
        shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emitColor", emitColor)
        for (m in meshes) {
            m.render(shaderProgram)
        }
    }

    fun cleanup() {
        for (m in meshes) m.cleanup()
    }
}

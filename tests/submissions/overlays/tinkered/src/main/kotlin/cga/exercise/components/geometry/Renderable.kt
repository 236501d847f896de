package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
        for (m in meshes) {
            m.render(shaderProgram)
        }
    }

    /** with a colour for the emission */
    fun renderBunt(shaderProgram: ShaderProgram, farbe: Vector3f) {
        shaderProgram.setUniform("leuchtFarbe", farbe)
        render(shaderProgram)
    }

    fun cleanup() {
        for (m in meshes) m.cleanup()
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    // 4.4
    fun render(shaderProgram: ShaderProgram, farbe: Vector3f) {
        shaderProgram.setUniform("emcol", farbe)
        render(shaderProgram)
    }

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("mm", getWorldModelMatrix(), false)
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

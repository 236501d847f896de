package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, glow: Vector3f) {
        shaderProgram.setUniform("modelM", getWorldModelMatrix(), false)
        shaderProgram.setUniform("glow", glow)
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

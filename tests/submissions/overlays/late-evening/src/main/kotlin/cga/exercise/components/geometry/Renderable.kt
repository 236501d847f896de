package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(var meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    //farbe = Farbinformation fuer die Emission (4.4)
    fun render(shaderProgram: ShaderProgram, farbe: Vector3f) {
        shaderProgram.setUniform("modelMat", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emitCol", farbe)
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

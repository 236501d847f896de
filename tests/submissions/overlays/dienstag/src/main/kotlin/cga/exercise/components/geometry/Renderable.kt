package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    // Blatt 4: Farbe, mit der die emissive Textur multipliziert wird
    var emitColor = Vector3f(1.0f, 1.0f, 1.0f)

    fun render(shaderProgram: ShaderProgram) {
        val model = getWorldModelMatrix()
        val normalMatrix = Matrix4f(model).invert().transpose()
        shaderProgram.setUniform("model_matrix", model, false)
        shaderProgram.setUniform("normal_matrix", normalMatrix, false)
        shaderProgram.setUniform("emitColor", emitColor)
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

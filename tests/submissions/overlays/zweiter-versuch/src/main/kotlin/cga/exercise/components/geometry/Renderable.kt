package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    // 4.4: Farbe, mit der die Emission multipliziert wird
    var leuchtfarbe = Vector3f(1f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("modelMat", getWorldModelMatrix(), false)
        shaderProgram.setUniform("leuchtfarbe", leuchtfarbe)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    /** Aufgabe 4.4: Farbe, mit der die Emission multipliziert wird */
    var leuchtfarbe = Vector3f(1.0f, 1.0f, 1.0f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model_matrix", getWorldModelMatrix(), false)
        shaderProgram.setUniform("glow_color", leuchtfarbe)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}

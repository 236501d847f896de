package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    /** 4.4: multiplied with the emissive texture */
    var emissionColor = Vector3f(1.0f, 1.0f, 1.0f)

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("model", getWorldModelMatrix(), false)
        shaderProgram.setUniform("emissionColor", emissionColor)
        for (m in meshes) {
            m.render(shaderProgram)
        }
    }

    fun cleanup() {
        for (m in meshes) m.cleanup()
    }
}

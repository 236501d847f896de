package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(pos: Vector3f, farbe: Vector3f, private val gamma: Float, private val phi: Float) :
    PointLight(pos, farbe, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    init {
        isSpot = true
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        // vorne ist -z, dann in den Viewspace
        val richtung = getWorldZAxis().negate()
        viewMatrix.transformDirection(richtung)
        shaderProgram.setUniform("$name.richtung", richtung)
        shaderProgram.setUniform("$name.gamma", gamma)
        shaderProgram.setUniform("$name.phi", phi)
    }
}

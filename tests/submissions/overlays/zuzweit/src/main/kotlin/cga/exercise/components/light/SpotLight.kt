package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight(
    startPosition: Vector3f,
    farbe: Vector3f,
    private val gamma: Float,
    private val phi: Float
) : PointLight(startPosition, farbe), ISpotLight {

    override val daempfung = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name, viewMatrix)
        // -z ist bei uns vorne
        val richtung = getWorldZAxis().negate()
        viewMatrix.transformDirection(richtung)
        shaderProgram.setUniform("$name.dirView", richtung)
        shaderProgram.setUniform("$name.kegel", Vector2f(gamma, phi))
    }
}

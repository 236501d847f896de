package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class SpotLight(
    position: Vector3f,
    lichtfarbe: Vector3f,
    private val gamma: Float,
    private val phi: Float
) : PointLight(position, lichtfarbe), ISpotLight {

    override val daempfung = Vector3f(0.5f, 0.05f, 0.01f)

    // leuchtet entlang der negativen z-Achse, Ergebnis im Viewspace
    fun getRichtung(viewMatrix: Matrix4f): Vector3f {
        val richtung = getWorldZAxis().negate()
        return viewMatrix.transformDirection(richtung)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        shaderProgram.setUniform(name + "Richtung", getRichtung(viewMatrix))
        shaderProgram.setUniform(name + "Gamma", gamma)
        shaderProgram.setUniform(name + "Phi", phi)
    }
}

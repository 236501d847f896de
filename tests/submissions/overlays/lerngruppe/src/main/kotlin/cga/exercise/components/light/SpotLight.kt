package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

/** gamma = innerer Kegel, phi = aeusserer Kegel (beide in rad, siehe Abbildung 2) */
class SpotLight(position: Vector3f, rgb: Vector3f, private val gamma: Float, private val phi: Float) :
    PointLight(position, rgb), ISpotLight {

    init {
        // Tabelle 1, zweite Zeile
        kFactors = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        shaderProgram.setUniform(name + "Heading", headingInView(viewMatrix))
        shaderProgram.setUniform(name + "Cone", Vector2f(gamma, phi))
    }

    // Richtung, kein Punkt: w = 0, also reicht der 3x3-Teil (Formel 1.8 aus Kapitel 3)
    private fun headingInView(viewMatrix: Matrix4f): Vector3f {
        val heading = getWorldZAxis().negate()
        return heading.mul(Matrix3f(viewMatrix))
    }
}

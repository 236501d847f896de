package cga.exercise.components.light

import cga.exercise.components.geometry.Matrices
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/** gamma: innerer Kegel, phi: äußerer Kegel, beide in rad */
class SpotLight(
    position: Vector3f,
    farbe: Vector3f,
    private val gamma: Float,
    private val phi: Float
) : PointLight(position, farbe), ISpotLight {

    override val K = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bindGrundwerte(shaderProgram, name)
        bindKegel(shaderProgram, name)

        // leuchtet in Richtung -z
        val D = getWorldZAxis().negate()
        shaderProgram.setUniform("D_$name", Matrices.richtungInView(viewMatrix, D))
    }

    private fun bindKegel(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("gamma_$name", gamma)
        shaderProgram.setUniform("phi_$name", phi)
    }
}

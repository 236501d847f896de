package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    lichtPos: Vector3f,
    lichtFarbe: Vector3f,
    private val innererWinkel: Float,
    private val aeussererWinkel: Float
) : PointLight(lichtPos, lichtFarbe), ISpotLight {

    init {
        daempfung = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        shaderProgram.setUniform(name + "Winkel", Vector2f(innererWinkel, aeussererWinkel))

        // Richtung in den Viewspace bringen
        val richtung = getWorldZAxis().negate()
        val richtungView = Vector4f(richtung, 0.0f).mul(viewMatrix)
        shaderProgram.setUniform(name + "Richtung", Vector3f(richtungView.x, richtungView.y, richtungView.z))
    }
}

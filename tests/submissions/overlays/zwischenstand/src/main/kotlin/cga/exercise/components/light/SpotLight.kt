package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    startPosition: Vector3f,
    lichtfarbe: Vector3f,
    private val innererWinkel: Float,
    private val aeussererWinkel: Float
) : PointLight(startPosition, lichtfarbe), ISpotLight {

    init {
        abschwaechung = Vector3f(0.5f, 0.05f, 0.01f)
        println("SpotLight: innen $innererWinkel aussen $aeussererWinkel")
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        shaderProgram.setUniform("$name.innerAngle", innererWinkel)
        shaderProgram.setUniform("$name.outerAngle", aeussererWinkel)

        // -z ist vorne
        val richtungWelt = getWorldZAxis().negate()
        val richtungView = viewMatrix.transform(Vector4f(richtungWelt, 0.0f))
        shaderProgram.setUniform("$name.direction", Vector3f(richtungView.x, richtungView.y, richtungView.z))
    }
}

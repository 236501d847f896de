package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    lightPos: Vector3f,
    lightColor: Vector3f,
    private val innererWinkel: Float,
    private val aeussererWinkel: Float
) : PointLight(lightPos, lightColor), ISpotLight {

    override var lightAtt = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)

        val richtung = Vector4f(getWorldZAxis().negate(), 0.0f)
        viewMatrix.transform(richtung)
        shaderProgram.setUniform(name + "_dir", Vector3f(richtung.x, richtung.y, richtung.z))
        shaderProgram.setUniform(name + "_angle", Vector2f(innererWinkel, aeussererWinkel))
    }
}

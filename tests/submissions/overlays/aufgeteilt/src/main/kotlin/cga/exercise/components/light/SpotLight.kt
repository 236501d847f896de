package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    position: Vector3f,
    lichtfarbe: Vector3f,
    private val innenwinkel: Float,
    private val aussenwinkel: Float
) : PointLight(position, lichtfarbe), ISpotLight {

    init {
        daempfung = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, "$name.light")
        val richtung = getWorldZAxis().negate()
        richtung.mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform("$name.dir", richtung)
        shaderProgram.setUniform("$name.inner", innenwinkel)
        shaderProgram.setUniform("$name.outer", aussenwinkel)
    }
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(pos: Vector3f, col: Vector3f, private val innen: Float, private val aussen: Float) : PointLight(pos, col), ISpotLight {

    init {
        att = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        shaderProgram.setUniform("spotDir", getWorldZAxis().negate().mul(Matrix3f(viewMatrix)))
        shaderProgram.setUniform("innen", innen)
        shaderProgram.setUniform("aussen", aussen)
    }
}

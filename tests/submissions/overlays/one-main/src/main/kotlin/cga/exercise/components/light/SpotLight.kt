package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(pos: Vector3f, col: Vector3f, private var gamma: Float, private var phi: Float) : PointLight(pos, col), ISpotLight {

    init {
        att = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        // Richtung in den Viewspace
        val dir = getWorldZAxis().negate()
        dir.mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform(name + "_dir", dir)
        shaderProgram.setUniform(name + "_gamma", gamma)
        shaderProgram.setUniform(name + "_phi", phi)
    }
}

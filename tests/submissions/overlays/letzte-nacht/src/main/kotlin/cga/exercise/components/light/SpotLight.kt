package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(p: Vector3f, c: Vector3f, private val wi: Float, private val wa: Float) : PointLight(p, c, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {
    // viewMatrix brauch ich nicht, macht der VS
    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        shaderProgram.setUniform("ld$name", getWorldZAxis().negate())
        shaderProgram.setUniform("wi$name", wi)
        shaderProgram.setUniform("wa$name", wa)
    }
}

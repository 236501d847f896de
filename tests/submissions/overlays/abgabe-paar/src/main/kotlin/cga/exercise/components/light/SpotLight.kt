package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(position: Vector3f, color: Vector3f, private val innerAngle: Float, private val outerAngle: Float) :
    PointLight(position, color, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        shaderProgram.setUniform("$name.direction", getWorldZAxis().negate())
        // cos only once here and not for each fragment
        shaderProgram.setUniform("$name.cosInner", cos(innerAngle))
        shaderProgram.setUniform("$name.cosOuter", cos(outerAngle))
    }
}

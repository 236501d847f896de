package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.cos
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(position: Vector3f, lightColor: Vector3f, private val inner: Float, private val outer: Float) :
    PointLight(position, lightColor, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, "$name.base")
        val forward = Vector4f(getWorldZAxis().negate(), 0.0f).mul(viewMatrix)
        shaderProgram.setUniform("$name.direction", Vector3f(forward.x, forward.y, forward.z))
        shaderProgram.setUniform("$name.innerCos", cos(inner))
        shaderProgram.setUniform("$name.outerCos", cos(outer))
    }
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    startPosition: Vector3f,
    lightColor: Vector3f,
    private val innerCone: Float,
    private val outerCone: Float,
    attenuation: Vector3f = Vector3f(0.5f, 0.05f, 0.01f)
) : PointLight(startPosition, lightColor, attenuation), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val direction = getWorldZAxis().negate()
        shaderProgram.setUniform("$name.direction", direction.mul(Matrix3f(viewMatrix)))
        shaderProgram.setUniform("$name.innerCone", innerCone)
        shaderProgram.setUniform("$name.outerCone", outerCone)
    }
}

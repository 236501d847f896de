package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    position: Vector3f,
    lightColor: Vector3f,
    private val innerAngle: Float,
    private val outerAngle: Float
) : PointLight(position, lightColor), ISpotLight {

    init {
        attenuation = Vector3f(0.5f, 0.05f, 0.01f)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        // the light shines along its negative z axis
        val direction = getWorldZAxis().negate()
        viewMatrix.transformDirection(direction)
        shaderProgram.setUniform(name + "Dir", direction)
        shaderProgram.setUniform(name + "Inner", innerAngle)
        shaderProgram.setUniform(name + "Outer", outerAngle)
    }
}

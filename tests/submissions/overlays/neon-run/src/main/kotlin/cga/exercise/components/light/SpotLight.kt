package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.cos
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(position: Vector3f, color: Vector3f, private val innerAngle: Float, private val outerAngle: Float) :
    PointLight(position, color), ISpotLight {
    override val kConstant = 0.5f
    override val kLinear = 0.05f
    override val kQuadratic = 0.01f

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, "$name.base", viewMatrix)
        val direction = getWorldZAxis().negate()
        viewMatrix.transformDirection(direction)
        shaderProgram.setUniform("$name.direction", direction)
        shaderProgram.setUniform("$name.cosInner", cos(innerAngle))
        shaderProgram.setUniform("$name.cosOuter", cos(outerAngle))
    }
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(
    lightPos: Vector3f,
    lightColor: Vector3f,
    private var innerCone: Float,
    private var outerCone: Float,
    attParam: Vector3f = Vector3f(0.5f, 0.05f, 0.01f)
) : PointLight(lightPos, lightColor, attParam), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        val direction = getWorldZAxis().negate().mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform("${name}Pos", getWorldPosition())
        shaderProgram.setUniform("${name}Color", lightColor)
        shaderProgram.setUniform("${name}Att", attParam)
        shaderProgram.setUniform("${name}Dir", direction)
        shaderProgram.setUniform("${name}Cone", org.joml.Vector2f(innerCone, outerCone))
    }
}

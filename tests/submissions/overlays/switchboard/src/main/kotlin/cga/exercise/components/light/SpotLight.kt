package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class SpotLight(position: Vector3f, color: Vector3f, private val inner: Float, private val outer: Float) :
    PointLight(position, color), ISpotLight {

    override val k = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super<PointLight>.bind(shaderProgram, name, viewMatrix)
        shaderProgram.setUniform("$name.axis", viewMatrix.transformDirection(getWorldZAxis()))
        shaderProgram.setUniform("$name.inner", inner)
        shaderProgram.setUniform("$name.outer", outer)
    }
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight(position: Vector3f, color: Vector3f, private val inner: Float, private val outer: Float) :
    PointLight(position, color, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super<PointLight>.bind(shaderProgram, name, viewMatrix)
        val modelView = viewMatrix.mul(getWorldModelMatrix(), Matrix4f())
        val direction = modelView.transformDirection(Vector3f(0.0f, 0.0f, -1.0f)).normalize()
        shaderProgram.setUniform("direction_$name", direction)
        shaderProgram.setUniform("cone_$name", Vector2f(inner, outer))
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    val color: Vector3f,
    private val k: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Transformable(), IPointLight {

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        val position = viewMatrix.transformPosition(getWorldPosition())
        shaderProgram.setUniform("position_$name", position)
        shaderProgram.setUniform("color_$name", color)
        shaderProgram.setUniform("k_$name", k)
    }
}

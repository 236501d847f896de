package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    color: Vector3f,
    k: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Light(position, color, k), IPointLight {
    override val type = 0

    override fun bind(shaderProgram: ShaderProgram, name: String) = bindCommon(shaderProgram, name)
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    color: Vector3f,
    attenuation: Attenuation = Attenuation.POINT
) : Light(position, color, attenuation), IPointLight {

    override fun bind(shaderProgram: ShaderProgram, name: String) = send(shaderProgram, name)
}

package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, color: Vector3f, attenuation: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)) :
    Light(position, color, attenuation), IPointLight {

    override fun bind(shaderProgram: ShaderProgram, name: String) = upload(shaderProgram, name)
}

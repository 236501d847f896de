package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, farbe: Vector3f) : Licht(position, farbe), IPointLight {

    override val K = Vector3f(1.0f, 0.5f, 0.1f)

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        bindGrundwerte(shaderProgram, name)
    }
}

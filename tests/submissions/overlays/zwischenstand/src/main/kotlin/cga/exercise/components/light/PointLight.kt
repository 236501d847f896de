package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(val startPosition: Vector3f, var lichtfarbe: Vector3f) : Transformable(), IPointLight {

    // Kc, Kl, Kq aus Tabelle 1
    var abschwaechung = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(startPosition)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.position", getWorldPosition())
        shaderProgram.setUniform("$name.color", lichtfarbe)
        shaderProgram.setUniform("$name.attenuation", abschwaechung)
        // println("$name: ${getWorldPosition()}")
    }
}

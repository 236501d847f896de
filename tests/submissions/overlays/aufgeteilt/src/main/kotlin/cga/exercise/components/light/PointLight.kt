package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, var lichtfarbe: Vector3f) : Transformable(), IPointLight {

    // Kc, Kl, Kq aus Tabelle 1
    protected var daempfung = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.pos", getWorldPosition())
        shaderProgram.setUniform("$name.color", lichtfarbe)
        shaderProgram.setUniform("$name.falloff", daempfung)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(var lichtPos: Vector3f, var lichtFarbe: Vector3f) : Transformable(), IPointLight {

    // Tabelle 1: Kc, Kl, Kq
    var daempfung = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(lichtPos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "Farbe", lichtFarbe)
        shaderProgram.setUniform(name + "Pos", getWorldPosition())
        shaderProgram.setUniform(name + "Daempfung", daempfung)
    }
}

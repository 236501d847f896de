package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(var lightPos: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {

    // Aufgabe 4.3.4, Tabelle 1
    open var lightAtt = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(lightPos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "_pos", getWorldPosition())
        shaderProgram.setUniform(name + "_color", lightColor)
        shaderProgram.setUniform(name + "_att", lightAtt)
    }
}

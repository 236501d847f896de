package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(var lightPos: Vector3f, var lightCol: Vector3f) : Transformable(), IPointLight {

    // Tabelle 1: Kc, Kl, Kq
    open var attParam = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(lightPos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "Pos", getWorldPosition())
        shaderProgram.setUniform(name + "Col", lightCol)
        shaderProgram.setUniform(name + "AttParam", attParam)
    }

    // fuer die Lichter in den Ecken, die liegen im Shader in Arrays
    fun bindArray(shaderProgram: ShaderProgram, name: String, index: Int) {
        shaderProgram.setUniform(name + "Pos[" + index + "]", getWorldPosition())
        shaderProgram.setUniform(name + "Col[" + index + "]", lightCol)
        shaderProgram.setUniform(name + "AttParam[" + index + "]", attParam)
    }
}

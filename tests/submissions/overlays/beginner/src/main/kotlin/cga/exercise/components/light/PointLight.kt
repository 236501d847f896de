package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight : Transformable, IPointLight {

    var lightPosition: Vector3f
    var lightCol: Vector3f
    var attParam: Vector3f

    constructor(lightPosition: Vector3f, lightCol: Vector3f, attParam: Vector3f) : super() {
        this.lightPosition = lightPosition
        this.lightCol = lightCol
        this.attParam = attParam
        translateGlobal(lightPosition)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "Color", lightCol)
        shaderProgram.setUniform(name + "AttParam", attParam)
        shaderProgram.setUniform(name + "Pos", getWorldPosition())
    }
}

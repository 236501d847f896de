package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(pos: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {

    //Kc, Kl, Kq
    var att = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(pos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "lightColor", lightColor)
        shaderProgram.setUniform(name + "lightPos", getWorldPosition())
        shaderProgram.setUniform(name + "att", att)
    }
}

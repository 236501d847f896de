package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(pos: Vector3f, var farbe: Vector3f) : Transformable(), IPointLight {

    // Kc, Kl, Kq
    var att: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(pos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "_pos", getWorldPosition())
        shaderProgram.setUniform(name + "_farbe", farbe)
        shaderProgram.setUniform(name + "_att", att)
    }
}

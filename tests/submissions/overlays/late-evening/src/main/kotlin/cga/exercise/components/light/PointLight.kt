package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(pos: Vector3f, var col: Vector3f) : Transformable(), IPointLight {

    //Kc, Kl, Kq
    open val att = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(pos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("pos$name", getWorldPosition())
        shaderProgram.setUniform("col$name", col)
        shaderProgram.setUniform("att$name", att)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(pos: Vector3f, var farbe: Vector3f, private val att: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)) : Transformable(), IPointLight {

    // Im Shader gibt es nur eine Lichtart, das Flag unterscheidet Punktlicht und Spot
    protected var isSpot = false

    init {
        translateGlobal(pos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.istSpot", if (isSpot) 1 else 0)
        shaderProgram.setUniform("$name.position", getWorldPosition())
        shaderProgram.setUniform("$name.farbe", farbe)
        shaderProgram.setUniform("$name.att", att)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, var rgb: Vector3f) : Transformable(), IPointLight {

    // Tabelle 1: (K_c, K_l, K_q)
    protected var kFactors = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.worldPosition", getWorldPosition())
        shaderProgram.setUniform("$name.rgb", rgb)
        shaderProgram.setUniform("$name.kFactors", kFactors)
    }
}

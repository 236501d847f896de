package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(wo: Vector3f, var farbe: Vector3f) : Transformable(), IPointLight {

    // kc, kl, kq
    var k = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(wo)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("pos$name", getWorldPosition())
        shaderProgram.setUniform("col$name", farbe)
        shaderProgram.setUniform("k$name", k)
    }
}

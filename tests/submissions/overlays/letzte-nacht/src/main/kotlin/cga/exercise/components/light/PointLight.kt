package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(p: Vector3f, var c: Vector3f, var k: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)) : Transformable(), IPointLight {
    init {
        translateGlobal(p)
    }

    // name = Nummer im Shader
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("lp$name", getWorldPosition())
        shaderProgram.setUniform("lc$name", c)
        shaderProgram.setUniform("lk$name", k)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(lightPos: Vector3f, var lightCol: Vector3f, var helligkeit: Float = 1.0f) : Transformable(), IPointLight {

    // x = Kc, y = Kl, z = Kq
    open var lightAttParam = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(lightPos)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        val col = Vector3f(lightCol).mul(helligkeit)
        shaderProgram.setUniform(name + "LightPos", getWorldPosition())
        shaderProgram.setUniform(name + "LightCol", col)
        shaderProgram.setUniform(name + "LightAttParam", lightAttParam)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    var lightPos: Vector3f,
    var lightColor: Vector3f,
    var attParam: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Transformable(), IPointLight {

    init {
        translateGlobal(lightPos)
    }

    // name ist "[0]", "[1]" ... bei den Punktlichtern
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("pointLightPos$name", getWorldPosition())
        shaderProgram.setUniform("pointLightColor$name", lightColor)
        shaderProgram.setUniform("pointLightAtt$name", attParam)
    }
}

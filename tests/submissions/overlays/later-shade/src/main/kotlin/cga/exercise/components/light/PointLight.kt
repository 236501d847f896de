package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * @param lightName name of the struct in the shader
 * @param attParam constant, linear and quadratic part; only the last one is physically right
 */
open class PointLight(
    lightPos: Vector3f,
    var lightCol: Vector3f,
    val lightName: String,
    var attParam: Vector3f = Vector3f(0f, 0f, 1f)
) : Transformable(), IPointLight {

    init {
        preTranslate(lightPos)
    }

    override fun bind(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("$lightName.pos", getWorldPosition())
        shaderProgram.setUniform("$lightName.col", lightCol)
        shaderProgram.setUniform("$lightName.attParam", attParam)
    }
}

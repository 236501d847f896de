package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    val lightColor: Vector3f,
    private val attenuation: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Transformable(), IPointLight {

    /** Between 0 (off) and 1. */
    var dimmer = 1.0f

    init {
        translateGlobal(position)
    }

    fun toggle() {
        dimmer = if (dimmer > 0.0f) 0.0f else 1.0f
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.position", getWorldPosition())
        shaderProgram.setUniform("$name.color", Vector3f(lightColor).mul(dimmer))
        shaderProgram.setUniform("$name.attenuation", attenuation)
    }
}

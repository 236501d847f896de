package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {

    // Kc, Kl, Kq
    var attenuation = Vector3f(POINT_ATTENUATION)

    init {
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "_pos", getWorldPosition())
        shaderProgram.setUniform(name + "_color", lightColor)
        shaderProgram.setUniform(name + "_att", attenuation)
    }

    companion object {
        val POINT_ATTENUATION = Vector3f(1.0f, 0.5f, 0.1f)
    }
}

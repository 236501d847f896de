package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight : Transformable, IPointLight {
    private lateinit var m_color: Vector3f
    private lateinit var m_attenuation: Vector3f

    constructor(position: Vector3f, color: Vector3f) : super() {
        translateGlobal(position)
        setColor(color)
        setAttenuation(1.0f, 0.5f, 0.1f)
    }

    fun setColor(color: Vector3f) {
        this.m_color = color
    }

    fun getColor(): Vector3f {
        return m_color
    }

    fun setAttenuation(constant: Float, linear: Float, quadratic: Float) {
        this.m_attenuation = Vector3f(constant, linear, quadratic)
    }

    /** name: the index of the light in brackets, as "[3]" */
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("uLightPosition" + name, getWorldPosition())
        shaderProgram.setUniform("uLightColor" + name, m_color)
        shaderProgram.setUniform("uLightAttenuation" + name, m_attenuation)
    }
}

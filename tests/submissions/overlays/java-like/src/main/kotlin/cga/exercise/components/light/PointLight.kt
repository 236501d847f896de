package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.UniformSender
import org.joml.Vector3f

open class PointLight : Transformable, IPointLight {

    private var lightColor: Vector3f
    private var attenuation: Vector3f

    constructor(position: Vector3f, lightColor: Vector3f) : super() {
        this.lightColor = Vector3f(lightColor)
        this.attenuation = Vector3f(DEFAULT_ATTENUATION)
        this.translateGlobal(position)
    }

    fun getLightColor(): Vector3f {
        return this.lightColor
    }

    fun setLightColor(lightColor: Vector3f) {
        this.lightColor = lightColor
    }

    fun getAttenuation(): Vector3f {
        return this.attenuation
    }

    fun setAttenuation(constant: Float, linear: Float, quadratic: Float) {
        this.attenuation.set(constant, linear, quadratic)
    }

    override fun bind(sender: UniformSender, index: Int) {
        sender.sendLight(index, this)
    }

    companion object {
        private val DEFAULT_ATTENUATION: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
    }
}

package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(
    startPosition: Vector3f,
    var lightColor: Vector3f,
    var intensity: Float = 1.0f,
    private val schalter: Int = -1
) : Transformable(), IPointLight {

    // Tabelle 1
    var kc = 1.0f
    var kl = 0.5f
    var kq = 0.1f

    // ein oder aus
    var istAn = true

    init {
        translateGlobal(startPosition)
    }

    /** switches the light with its key */
    fun tasteGedrueckt(key: Int) {
        if (key == schalter) istAn = !istAn
    }

    fun farbeFuerShader(): Vector3f {
        if (istAn == false) {
            return Vector3f(0.0f, 0.0f, 0.0f)
        }
        val farbe = Vector3f(lightColor)
        return farbe.mul(intensity)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        val position = getWorldPosition()
        val k = Vector3f(kc, kl, kq)
        shaderProgram.setUniform(name + "_position", position)
        shaderProgram.setUniform(name + "_farbe", farbeFuerShader())
        shaderProgram.setUniform(name + "_k", k)
    }
}
